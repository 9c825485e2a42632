#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model_text.h"

namespace foldwright::testing {
namespace {

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
  const PolygonSoup soup = read_text(binary_stl(0, 3), "a.stl");
  EXPECT_EQ(soup.face_count(), 3);
  EXPECT_EQ(repair_named(soup.repairs, "wrong-count").count, 3);
}

TEST(ReadStl, ReportsTrailingBytes) {
  const PolygonSoup soup = read_text(binary_stl(2, 2) + "trailer", "a.stl");
  EXPECT_EQ(soup.face_count(), 2);
  EXPECT_EQ(repair_named(soup.repairs, "trailing-bytes").count, 7);
}

TEST(ReadStl, RefusesDamagedBinary) {
  EXPECT_EQ(refusal(binary_stl(4'000'000'000, 2), "a.stl"),
            "triangle 3: the file ends here, but its header announces 4000000000 triangles");
  EXPECT_EQ(refusal(binary_stl(1, 1, std::numeric_limits<float>::infinity()), "a.stl"),
            "triangle 1: a coordinate is not a finite number");
  EXPECT_EQ(refusal("short", "a.stl"),
            "the file has 5 bytes, too few for the header of a binary STL");
  EXPECT_EQ(refusal(binary_stl(0, 0), "a.stl"), "the file has neither vertices nor faces");
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
            "line 7: the file ends where 'endloop' is expected");
  EXPECT_EQ(refusal("solid\n" + kFacet + "fact normal 0 0 0\n", "a.stl"),
            "line 9: 'fact' stands where 'facet' is expected");
  EXPECT_EQ(refusal("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 nan\n", "a.stl"),
            "line 4: a coordinate is not a finite number");
}

TEST(ReadStl, TellsHowFarCoordinatesWereRounded) {
  EXPECT_EQ(read_text(binary_stl(1, 1), "a.stl").precision, std::ldexp(1.0, -24));
  const std::string facet =
      "facet normal 0.12345 0 0\nouter loop\nvertex 0 0 0.125\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\n";
  EXPECT_DOUBLE_EQ(read_text("solid\n" + facet + "endsolid\n", "a.stl").precision, 5e-4);
}

}  // namespace
}  // namespace foldwright::testing
