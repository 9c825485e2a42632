#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "model_text.h"

namespace foldwright::testing {
namespace {

using Corners = std::vector<int>;

/// Bytes of a value, in the given order; the tests run on little-endian machines.
template <typename T>
std::string bytes_of(T value, bool big_endian) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A triangle with properties of many types in an unusual order, and an element before the
/// vertices.
std::string binary_ply(bool big_endian) {
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\ncomment x\nelement extra 2\nproperty list ushort short tags\n"
                     "element vertex 3\nproperty uchar red\nproperty double z\nproperty float y\n"
                     "property int x\nelement face 1\nproperty uint flag\n"
                     "property list uint ushort vertex_index\nend_header\n";
  const auto append = [&](auto value) { text += bytes_of(value, big_endian); };
  for (int tags = 0; tags < 2; ++tags) {
    append(std::uint16_t{2});
    append(std::int16_t{-1});
    append(std::int16_t{-2});
  }
  for (int v = 0; v < 3; ++v) {
    append(std::uint8_t{255});
    append(double{0.25});
    append(static_cast<float>(v == 2));
    append(std::int32_t{v == 1});
  }
  append(std::uint32_t{7});
  append(std::uint32_t{3});
  for (const std::uint16_t corner : {2, 0, 1}) append(corner);
  return text;
}

const std::string kAsciiHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(ReadPly, TakesAnyPropertiesInEitherByteOrder) {
  for (const bool big_endian : {false, true}) {
    const PolygonSoup soup = read_text(binary_ply(big_endian), "a.ply");
    ASSERT_EQ(soup.face_count(), 1);
    EXPECT_EQ(corners_of(soup, 0), (Corners{2, 0, 1}));
    EXPECT_EQ(soup.positions[1], Vec3(1, 0, 0.25));
    EXPECT_EQ(soup.positions[2], Vec3(0, 1, 0.25));
  }
}

TEST(ReadPly, TakesAsciiWithAnyLineBreaks) {
  std::string text = kAsciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(corners_of(read_text(text, "a.ply"), 0), (Corners{0, 1, 2}));
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(corners_of(read_text(text, "a.ply"), 0), (Corners{0, 1, 2}));
}

TEST(ReadPly, NeverReadsBeyondTheEnd) {
  const std::string whole = binary_ply(false);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(refusal(whole.substr(0, size), "a.ply"), "") << size;
  }
}

TEST(ReadPly, IgnoresTheCountOfAnElementWithoutProperties) {
  const std::string header = "ply\nformat ascii 1.0\nelement nothing 999999999999\n";
  const std::string text =
      header + kAsciiHeader.substr(kAsciiHeader.find("element")) + "0 0 0 1 0 0 0 1 0 3 0 1 2";
  EXPECT_EQ(read_text(text, "a.ply").face_count(), 1);
}

TEST(ReadPly, AsksNothingOfElementsThatAreEmpty) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 0\nend_header\n0 0 0\n";
  EXPECT_EQ(refusal(header, "a.ply"), "no-faces what=vertices");
}

TEST(ReadPly, NamesThePlaceOfWhatIsWrong) {
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply"),
            "truncated place=line at=3 what=ply-header");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex -3\n", "a.ply"),
            "bad-header place=line at=3 what=element-count element=vertex");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n", "a.ply"),
            "bad-header place=line at=4 what=property-type word=quad");
  EXPECT_EQ(refusal(kAsciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.ply"),
            "bad-index place=line at=13 what=beyond index=3 vertices=3 first=0");
  EXPECT_EQ(refusal(kAsciiHeader + "0 0 0\n1 0 inf\n", "a.ply"),
            "not-finite place=line at=11 what=coordinate");
  const std::string cut = binary_ply(true);
  EXPECT_EQ(refusal(cut.substr(0, cut.size() - 1), "a.ply"),
            "truncated place=face at=0 what=element announced=1 element=face");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
                    "a.ply"),
            "bad-header what=property element=vertex property=y");
}

TEST(ReadPly, TellsHowFarCoordinatesWereRounded) {
  EXPECT_EQ(read_text(binary_ply(true), "a.ply").precision, std::ldexp(1.0, -24));
  EXPECT_DOUBLE_EQ(
      read_text(kAsciiHeader + "0 0 0.5\n1 0.26 0\n0 1 0\n3 0 1 2\n", "a.ply").precision, 5e-3);
}

/// An ASCII file with one element of lists of `type`, and four vertices after it.
std::string with_list(const std::string& element, const std::string& type, const std::string& name,
                      const std::string& lists) {
  const auto count = std::to_string(std::count(lists.begin(), lists.end(), '\n'));
  return "ply\r\ncomment a\r\nformat ascii 1.0\r\nobj_info b\r\nelement " + element + " " + count +
         "\r\nproperty list uchar " + type + " " + name +
         "\r\ncomment c\r\nelement vertex 4\r\nproperty double x\r\nproperty double y\r\nproperty "
         "double z\r\nend_header\r\n" +
         lists + "0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 0\r\n";
}

TEST(ReadPly, TakesFacesBeforeVerticesAndListsOfAnyName) {
  for (const char* name : {"vertex_index", "vertex_indices", "corners"}) {
    const PolygonSoup soup =
        read_text(with_list("face", "int", name, "3 0 1 2\n4 0 1 3 2\n"), "a.ply");
    ASSERT_EQ(soup.face_count(), 2);
    EXPECT_EQ(corners_of(soup, 1), (Corners{0, 1, 3, 2}));
  }
  EXPECT_EQ(refusal(with_list("face", "float", "texcoord", "3 0 1 2\n"), "a.ply"),
            "bad-header what=property element=face property=vertex_indices");
}

TEST(ReadPly, TakesTriangleStrips) {
  // A strip of two triangles, a new one after -1, and a strip that repeats a vertex.
  const std::string strips = "8 0 1 2 3 -1 3 2 1\n5 0 1 1 2 3\n";
  const PolygonSoup soup =
      read_text(with_list("tristrips", "int", "vertex_indices", strips), "a.ply");
  ASSERT_EQ(soup.face_count(), 4);
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners_of(soup, 1), (Corners{2, 1, 3}));  // turned back
  EXPECT_EQ(corners_of(soup, 2), (Corners{3, 2, 1}));
  EXPECT_EQ(corners_of(soup, 3), (Corners{1, 2, 3}));
  const std::string unsigned_strips = "7 0 1 2 4294967295 3 2 1\n";
  EXPECT_EQ(read_text(with_list("tristrips", "uint", "vertex_indices", unsigned_strips), "a.ply")
                .face_count(),
            2);
  EXPECT_EQ(refusal(with_list("tristrips", "int", "vertex_indices", "3 0 1 9\n"), "a.ply"),
            "bad-index place=line at=13 what=beyond index=9 vertices=4 first=0");
}

/// A triangle whose vertices and whose face have more than they must. `vertex_values`: of the
/// three vertices in turn.
PolygonSoup triangle_with(const std::string& vertex_properties,
                          const std::array<std::string, 3>& vertex_values,
                          const std::string& face_properties, const std::string& face_values) {
  return read_text(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\n" +
          vertex_properties + "element face 1\nproperty list uchar int vertex_indices\n" +
          face_properties + "end_header\n0 0 0 " + vertex_values[0] + "\n1 0 0 " +
          vertex_values[1] + "\n0 1 0 " + vertex_values[2] + "\n3 0 1 2 " + face_values + "\n",
      "a.ply");
}

TEST(ReadPly, LeavesOtherPropertiesAlone) {
  EXPECT_TRUE(triangle_with("property float nx\n", {"1", "1", "1"}, "property uchar flags\n", "1")
                  .looks.empty());
  EXPECT_TRUE(triangle_with("property uchar red\n", {"1", "1", "1"}, "", "").looks.empty())
      << "one number is no colour";
}

TEST(ReadPly, ReadsColoursOfVertices) {
  const char* const types[] = {"uchar", "float", "ushort"};
  const char* const full[] = {"255", "1", "65535"};
  for (int i = 0; i < 3; ++i) {
    const std::string one = full[i];
    std::string properties;
    for (const char* name : {"red", "green", "blue"}) {
      properties += "property " + std::string(types[i]) + " " + name + "\n";
    }
    const SoupLooks looks =
        triangle_with(properties, {one + " 0 0", "0 " + one + " 0", "0 0 0"}, "", "").looks;
    EXPECT_EQ(looks.colours, (std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 0}})) << types[i];
  }
}

TEST(ReadPly, ReadsColoursAndMaterialsOfFaces) {
  const SoupLooks looks = triangle_with("", {"", "", ""},
                                        "property uchar red\nproperty uchar green\n"
                                        "property uchar blue\nproperty int material\n",
                                        "1 2 3 4")
                              .looks;
  EXPECT_EQ(looks.colours, (std::vector<Rgb>{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
  EXPECT_EQ(looks.materials, (std::vector<int>{4}));
}

TEST(ReadPly, ReadsPlacesOfVerticesAndOfCorners) {
  const std::vector<PicturePlace> places = {{0, 0.5}, {1, 0.5}, {0, 1}};
  EXPECT_EQ(triangle_with("property float s\nproperty float t\n", {"0 0.5", "1 0.5", "0 1"}, "", "")
                .looks.places,
            places);
  EXPECT_EQ(
      triangle_with("", {"", "", ""}, "property list uchar float texcoord\n", "6 0 0.5 1 0.5 0 1")
          .looks.places,
      places);
}

}  // namespace
}  // namespace foldwright::testing
