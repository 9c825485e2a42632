#include <gtest/gtest.h>

#include "model_text.h"

namespace foldwright::testing {
namespace {

using Corners = std::vector<int>;

// A square and a triangle over five vertices, without a header.
const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n";

void expect_body(const PolygonSoup& soup) {
  EXPECT_EQ(soup.positions.size(), 5u);
  ASSERT_EQ(soup.face_count(), 2);
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(corners_of(soup, 1), (Corners{1, 4, 2}));
}

TEST(ReadOff, TakesEveryShapeOfHeader) {
  for (const char* header : {"OFF\n5 2 0\n", "OFF 5 2 0\n", "5 2 0\n", "OFF\n# comment\n\n5 2 0\n",
                             "OFF # comment\n5 2\n", "COFF\n5 2 0\n", "STCNOFF\n5 2 0\n"}) {
    SCOPED_TRACE(header);
    expect_body(read_text(header + kBody, "a.off"));
  }
}

TEST(ReadOff, SkipsNormalsAndColours) {
  const std::string body =
      "0 0 0 0 0 1 255 0 0\n1 0 0 .5 .5 .5 1\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3 255 0 0\n3 1 4 2 "
      "0.5\n";
  expect_body(read_text("CNOFF\n5 2 0\n" + body, "a.off"));
}

TEST(ReadOff, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(refusal("OFF\n999999999 1 0\n0 0 0\n", "a.off"),
            "line 3: the file ends after 1 of 999999999 vertices");
  EXPECT_EQ(refusal("OFF\n1 999999999 0\n0 0 0\n1 0\n", "a.off"),
            "line 4: the file ends after 1 of 999999999 faces");
  EXPECT_EQ(refusal("OFF\n5 2 0\n0 0 0", "a.off"), "line 3: the file ends after 1 of 5 vertices");
  EXPECT_EQ(refusal("OFF\n1 1 0\n0 0 0\n999999999 0 0\n", "a.off"),
            "line 4: the file ends where a number is expected");
  EXPECT_EQ(refusal("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "a.off"),
            "line 4: face refers to vertex 1, but the file has 1 vertices, counted from 0");
  EXPECT_EQ(refusal("OFF\n-1 1 0\n", "a.off"), "line 2: the counts must not be negative");
  EXPECT_EQ(refusal("PLY\n", "a.off"), "line 1: an OFF file begins with OFF, this one with 'PLY'");
  EXPECT_EQ(refusal("4OFF\n", "a.off"),
            "line 1: '4OFF' files with more than 3 coordinates are not read");
  EXPECT_EQ(refusal("OFF BINARY\n", "a.off"), "line 1: binary OFF files are not read");
}

TEST(ReadOff, TellsHowFarCoordinatesWereRounded) {
  EXPECT_DOUBLE_EQ(
      read_text("OFF\n3 1 0\n0 0 0.25\n1 0.5 0\n0 1 0\n3 0 1 2 0.1234\n", "a.off").precision, 5e-3);
}

}  // namespace
}  // namespace foldwright::testing
