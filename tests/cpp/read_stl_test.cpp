#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model_text.h"

namespace foldwright::testing {
namespace {

constexpr Rgb kWhite = {255, 255, 255};
constexpr Rgb kRed = {255, 0, 0};

/// Binary STL whose header announces `announced` triangles and is followed by `present`.
std::string binary_stl(std::uint32_t announced, int present, float first = 0) {
  std::string bytes = "solid but binary";
  bytes.resize(80, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(announced);
  for (int t = 0; t < present; ++t) {
    for (const float x : {0.f, 0.f, 0.f, first, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(x);
    bytes.append(2, '\0');
  }
  return bytes;
}

const std::string kFacet =
    "facet normal nan 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\n";

TEST(ReadStl, TakesBinaryByItsSize) {
  static_assert(std::endian::native == std::endian::little);
  const PolygonSoup soup = read_text(binary_stl(2, 2), "a.stl");
  EXPECT_EQ(soup.face_count(), 2);
  EXPECT_EQ(soup.positions[1], Vec3(1, 0, 0));
  EXPECT_TRUE(soup.repairs.empty());
}

TEST(ReadStl, ReadsAllTrianglesBehindAStaleCount) {
  for (const std::uint32_t announced : {0u, 2u, 4u, 0xFFFFFFFFu}) {
    const PolygonSoup soup = read_text(binary_stl(announced, 3), "a.stl");
    EXPECT_EQ(soup.face_count(), 3);
    EXPECT_EQ(repair_named(soup.repairs, "wrong-count").count, 3);
  }
}

TEST(ReadStl, ReadsAllTrianglesBetweenNoCountAndTrailingBytes) {
  const PolygonSoup soup = read_text(binary_stl(0, 3) + "trailer", "a.stl");
  EXPECT_EQ(soup.face_count(), 3);
  EXPECT_EQ(repair_named(soup.repairs, "wrong-count").count, 3);
  EXPECT_EQ(repair_named(soup.repairs, "trailing-bytes").count, 7);
}

TEST(ReadStl, ReportsTrailingBytes) {
  const PolygonSoup soup = read_text(binary_stl(2, 2) + "trailer", "a.stl");
  EXPECT_EQ(soup.face_count(), 2);
  EXPECT_EQ(repair_named(soup.repairs, "trailing-bytes").count, 7);
}

TEST(ReadStl, RefusesDamagedBinary) {
  const std::string cut = binary_stl(4'000'000'000, 2);
  EXPECT_EQ(refusal(cut.substr(0, cut.size() - 1), "a.stl"),
            "truncated place=triangle at=2 what=triangles announced=4000000000");
  EXPECT_EQ(refusal(binary_stl(1, 1, std::numeric_limits<float>::infinity()), "a.stl"),
            "not-finite place=triangle at=1 what=coordinate");
  EXPECT_EQ(refusal(std::string("sho\0t", 5), "a.stl"), "truncated what=stl-header bytes=5");
  EXPECT_EQ(refusal("some text\n", "a.stl"), "bad-syntax place=line at=1 word=some expected=facet");
  EXPECT_EQ(refusal(binary_stl(0, 0), "a.stl"), "no-faces what=nothing");
}

TEST(ReadStl, TakesAsciiInAnyCaseAndWithSeveralSolids) {
  const PolygonSoup soup =
      read_text("SOLID a b\n" + kFacet +
                    "endsolid\nsolid\nFACET NORMAL 0 0 0\r\nOuter Loop vertex 0 0 0 "
                    "vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 endloop endfacet endsolid x",
                "a.STL");
  ASSERT_EQ(soup.face_count(), 2);
  EXPECT_EQ(corners_of(soup, 1).size(), 4u);
  EXPECT_TRUE(soup.repairs.empty());
}

TEST(ReadStl, ReportsAMissingEnd) {
  const PolygonSoup soup = read_text("solid\n" + kFacet, "a.stl");
  EXPECT_EQ(repair_named(soup.repairs, "missing-endsolid").count, 1);
}

TEST(ReadStl, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(refusal("solid\n" + kFacet.substr(0, kFacet.find("endl") + 5), "a.stl"),
            "truncated place=line at=7 what=keyword expected=endloop");
  EXPECT_EQ(refusal("solid\n" + kFacet + "fact normal 0 0 0\n", "a.stl"),
            "bad-syntax place=line at=9 word=fact expected=facet");
  EXPECT_EQ(refusal("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 nan\n", "a.stl"),
            "not-finite place=line at=4 what=coordinate");
}

TEST(ReadStl, TellsHowFarCoordinatesWereRounded) {
  EXPECT_EQ(read_text(binary_stl(1, 1), "a.stl").precision, std::ldexp(1.0, -24));
  const std::string facet =
      "facet normal 0.12345 0 0\nouter loop\nvertex 0 0 0.126\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\n";
  EXPECT_DOUBLE_EQ(read_text("solid\n" + facet + "endsolid\n", "a.stl").precision, 5e-4);
}

/// Two triangles that share an edge, in spellings that programs write.
void expect_two_triangles(const std::string& text) {
  SCOPED_TRACE(text);
  const PolygonSoup soup = read_text(text, "a.stl");
  ASSERT_EQ(soup.face_count(), 2);
  EXPECT_EQ(corners_of(soup, 0).size(), 3u);
  EXPECT_EQ(corners_of(soup, 1).size(), 3u);
  EXPECT_EQ(soup.positions[5], Vec3(0, 1, 0));
  EXPECT_TRUE(soup.repairs.empty());
}

TEST(ReadStl, TakesEverySpellingOfItsWords) {
  const std::string one = "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n";
  const std::string two = "vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n";
  const auto both = [&](const std::string& before, const std::string& after) {
    return before + one + after + before + two + after;
  };
  const std::string begin = "facet normal 0 0 1\nouter loop\n";
  const std::string end = "endloop\nendfacet\n";
  expect_two_triangles("solid\n" + both(begin, "end loop\nend facet\n") + "end solid x\n");
  expect_two_triangles("solid a\n" + begin + one + end + "outer loop\n" + two + end +
                       "endsolid a\n");
  expect_two_triangles("solid\n" + both("facet\nouter loop\n", end) + "endsolid\n");
  expect_two_triangles("solid\n" + both("facet normal\n0 0\n1\nouter loop\n", end) + "endsolid\n");
  expect_two_triangles("solid\n" + both(begin, "endloop\n") + "endsolid\n");
  expect_two_triangles("solid\n" + both(begin, "endfacet\n") + "endsolid\n");
  expect_two_triangles("solid\n" + both("loop\n", "") + "endsolid\n");
  expect_two_triangles("solid\n" + one + two + "endsolid\n");
  expect_two_triangles("solid\n" + both("color 1 0 0\n" + begin, end) + "endsolid\n");
  expect_two_triangles("facet normal 0 0 1\nouter loop\n" + one + end + begin + two + end);
}

TEST(ReadStl, TakesNamesOfAnyWords) {
  for (const char* name : {"facet", "endsolid vertex", "facet model", "# 1", "\xFF\xE9"}) {
    EXPECT_EQ(
        read_text("solid " + std::string(name) + "\n" + kFacet + "endsolid " + name + "\n", "a.stl")
            .face_count(),
        1)
        << name;
  }
}

TEST(ReadStl, TakesAFileInOneLine) {
  std::string text = "solid a b " + kFacet + kFacet + "endsolid a b";
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_EQ(read_text(text, "a.stl").face_count(), 2);
}

TEST(ReadStl, ReadsColoursOfTriangles) {
  EXPECT_EQ(looks_of(read_text(binary_stl(2, 2), "a.stl")), "");
  std::string odd = binary_stl(2, 2);
  odd[84 + 50 - 2] = 'x';  // no colour, whatever it is
  EXPECT_EQ(looks_of(read_text(odd, "a.stl")), "");
  std::string marked = binary_stl(2, 2);
  marked[84 + 2 * 50 - 1] = '\xFC';  // of the second triangle: red, its bits above those of others
  EXPECT_EQ(read_text(marked, "a.stl").looks.colours,
            (std::vector<Rgb>{kWhite, kWhite, kWhite, kRed, kRed, kRed}));
}

TEST(ReadStl, ReadsAColourOfAllTriangles) {
  std::string text = binary_stl(2, 2).replace(20, 10, "COLOR=\xFF\1\2\xFF");
  text[84 + 50 - 1] = '\x80';  // the first triangle has the common colour
  const Rgb common = {255, 1, 2};
  const Rgb black = {0, 0, 0};
  EXPECT_EQ(read_text(text, "a.stl").looks.colours,
            (std::vector<Rgb>{common, common, common, black, black, black}));
}

TEST(ReadStl, ReadsColoursInText) {
  EXPECT_EQ(looks_of(read_text("solid\n" + kFacet + "endsolid\n", "a.stl")), "");
  const PolygonSoup soup = read_text("solid\ncolor 1 0 0\n" + kFacet + "endsolid\n", "a.stl");
  EXPECT_EQ(soup.looks.colours, (std::vector<Rgb>{kRed, kRed, kRed}));
}

}  // namespace
}  // namespace foldwright::testing
