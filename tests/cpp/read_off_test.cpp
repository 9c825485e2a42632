#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

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
                             "OFF # comment\n5 2\n", "COFF\n5 2 0\n", "STCNOFF\n5 2 0\n",
                             "off\n5 2 0\n", "NCOFF\n5 2 0\n", "cnoff\n5 2 0\n", "nOFF\n3\n5 2 0\n",
                             "nOFF 3 5 2 0\n", "OFF\n# a\n5 2 0 # b\n# c\n\n"}) {
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
            "truncated place=line at=3 what=vertices done=1 announced=999999999");
  EXPECT_EQ(refusal("OFF\n1 999999999 0\n0 0 0\n1 0\n", "a.off"),
            "truncated place=line at=4 what=faces done=1 announced=999999999");
  EXPECT_EQ(refusal("OFF\n5 2 0\n0 0 0", "a.off"),
            "truncated place=line at=3 what=vertices done=1 announced=5");
  EXPECT_EQ(refusal("OFF\n1 1 0\n0 0 0\n999999999 0 0\n", "a.off"),
            "truncated place=line at=4 what=corners");
  EXPECT_EQ(refusal("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "a.off"),
            "bad-index place=line at=4 what=beyond index=1 vertices=1 first=0");
  EXPECT_EQ(refusal("OFF\n-1 1 0\n", "a.off"), "bad-header place=line at=2 what=counts");
  EXPECT_EQ(refusal("PLY\n", "a.off"), "bad-header place=line at=1 what=off-magic word=PLY");
  EXPECT_EQ(refusal("OFF\n", "a.off"), "truncated place=line at=1 what=header-only");
  EXPECT_EQ(refusal("nOFF\n2\n1 1 0\n0 0\n", "a.off"), "bad-header what=dimensions dimensions=2");
  EXPECT_EQ(refusal("4OFF\n1 1 0\n0 0 0 0\n3 0 0 0\n", "a.off"),
            "not-finite place=line at=3 what=weight");
}

TEST(ReadOff, LeavesTheNextLineToItself) {
  // A vertex and a face lack a number; all others keep theirs.
  const PolygonSoup soup = read_text(
      "OFF\n5 4 0\n0 0 0\n1 0 0\n1 10\n0 1 0\n2 0 0\n3 0 1 3\n3 1 4\n3 0 2 3\n3 1 4 3\n", "a.off");
  EXPECT_EQ(soup.positions[3], Vec3(0, 1, 0));
  ASSERT_EQ(soup.face_count(), 4);
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 3}));
  EXPECT_EQ(corners_of(soup, 3), (Corners{1, 4, 3}));
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.off"),
            "truncated place=line at=4 what=coordinates");
}

TEST(ReadOff, TellsHowFarCoordinatesWereRounded) {
  EXPECT_DOUBLE_EQ(
      read_text("OFF\n3 1 0\n0 0 0.26\n1 0.5 0\n0 1 0\n3 0 1 2 0.1234\n", "a.off").precision, 5e-3);
}

TEST(ReadOff, DividesByTheFourthCoordinate) {
  for (const char* keyword : {"4OFF", "4nOFF 3"}) {
    const PolygonSoup soup =
        read_text(keyword + std::string("\n3 1 0\n0 0 2 1\n2 0 0 2\n0 1 0 .5\n3 0 1 2\n"), "a.off");
    EXPECT_EQ(soup.positions[0], Vec3(0, 0, 2));
    EXPECT_EQ(soup.positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(soup.positions[2], Vec3(0, 2, 0));
  }
}

TEST(ReadOff, TakesLinesBrokenAnywhere) {
  for (const char* text :
       {// Everything in one line, with and without the number of edges.
        "OFF 5 2 0 0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 4 0 1 2 3 3 1 4 2",
        "OFF 5 2 0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 4 0 1 2 3 3 1 4 2",
        // One number per line, and comments between.
        "OFF\n5\n2\n# "
        "edges\n0\n0\n0\n0\n1\n0\n0\n1\n1\n0\n0\n1\n0\n2\n0\n0\n4\n0\n1\n2\n3\n3\n1\n4\n2\n",
        // Several vertices per line, then several faces.
        "OFF\n5 2 0\n0 0 0 1 0 0\n1 1 0 # comment\n0 1 0 2 0 0\n4 0 1 2 3 3 1 4 2\n",
        // A normal in the line after its vertex.
        "NOFF\n5 2 0\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n1 1 0\n0 0 1\n0 1 0\n0 0 1\n2 0 0\n0 0 1\n4 0 1 "
        "2 3\n3 1 4 2\n",
        // Colours of vertices (with alpha) and of faces (without), all told.
        "COFF 5 2 0 0 0 0 9 9 9 1 1 0 0 9 9 9 1 1 1 0 9 9 9 1 0 1 0 9 9 9 1 2 0 0 9 9 9 1\n"
        "4 0 1 2 3 255 0 0 3 1 4 2 255 0 0\n",
        // A face that goes on in the next line, with one vertex per line.
        "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1\n  2 3\n3 1 4 2\n"}) {
    SCOPED_TRACE(text);
    const PolygonSoup soup = read_text(text, "a.off");
    expect_body(soup);
    EXPECT_EQ(soup.positions[4], Vec3(2, 0, 0));
    EXPECT_TRUE(soup.repairs.empty());
  }
}

TEST(ReadOff, SkipsColoursOfAnyLengthPerLine) {
  expect_body(
      read_text("OFF\n5 2 0\n0 0 0 9\n1 0 0 9 9\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3 7\n3 1 4 2 .5 "
                ".5 .5 1\n",
                "a.off"));
}

TEST(ReadOff, ReportsLinesAfterTheLastFace) {
  const PolygonSoup soup = read_text("OFF\n5 2 0\n" + kBody + "2 0 1\n2 1 2\n", "a.off");
  expect_body(soup);
  EXPECT_EQ(repair_named(soup.repairs, "trailing-lines").count, 2);
}

/// Bytes of a number of 4 bytes, big-endian; the tests run on little-endian machines.
template <typename T>
void append_big_endian(std::string& bytes, T value) {
  static_assert(sizeof value == 4);
  std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
  bytes.append(raw.rbegin(), raw.rend());
}

/// A triangle whose vertices have `extra` numbers after their coordinates.
std::string binary_off(const std::string& header, int extra) {
  std::string bytes = header;
  const auto integer = [&](std::int32_t value) { append_big_endian(bytes, value); };
  for (const int count : {3, 1, 0}) integer(count);
  for (const Vec3& position : {Vec3(0, 0, 0.5), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    for (const double x : position) append_big_endian(bytes, static_cast<float>(x));
    for (int i = 0; i < extra; ++i) append_big_endian(bytes, 1.0f);
  }
  for (const int number : {3, 2, 0, 1, 3}) integer(number);  // corners, then a colour's length
  for (int i = 0; i < 3; ++i) append_big_endian(bytes, 0.25f);
  return bytes;
}

TEST(ReadOff, TakesBinaryFiles) {
  const std::string dimension("\0\0\0\3", 4);
  for (const auto& [header, extra] : {std::pair<std::string, int>{"OFF BINARY\n", 0},
                                      {"STCNOFF BINARY\r\n", 9},
                                      {"4OFF BINARY\n", 1},
                                      {"nOFF BINARY\n" + dimension, 0}}) {
    const PolygonSoup soup = read_text(binary_off(header, extra), "a.off");
    ASSERT_EQ(soup.face_count(), 1) << header;
    EXPECT_EQ(corners_of(soup, 0), (Corners{2, 0, 1})) << header;
    EXPECT_EQ(soup.positions[0], Vec3(0, 0, 0.5)) << header;
    EXPECT_EQ(soup.precision, std::ldexp(1.0, -24)) << header;
  }
  const std::string cut = binary_off("OFF BINARY\n", 0).substr(0, 11 + 12 + 20);
  EXPECT_EQ(refusal(cut, "a.off"), "truncated place=vertex at=1 what=more");
  EXPECT_EQ(refusal("OFF BINARY\n", "a.off"), "truncated what=header-only");
}

TEST(ReadOff, KnowsWhichLooksAFileHas) {
  const std::string coloured_face = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n";
  const std::pair<std::string, const char*> cases[] = {
      {"OFF\n5 2 0\n" + kBody, ""},
      {"NOFF\n5 2 0\n" + kBody, ""},
      {"OFF\n3 1 0\n" + coloured_face, "colours"},
      {"OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2 255 0 0", "colours"},
      {binary_off("OFF BINARY\n", 0), "colours"},
      {binary_off("STOFF BINARY\n", 2), "colours places"}};
  for (const auto& [text, looks] : cases) {
    EXPECT_EQ(looks_of(read_text(text, "a.off")), looks) << text;
  }
}

TEST(ReadOff, ReadsColoursAndPlacesBehindNormals) {
  const std::string text =
      "STNCOFF 3 1 0\n0 0 0  0 0 1  255 0 0 255  0 0.5\n1 0 0  0 0 1  0 255 0 255  1 0.5\n"
      "0 1 0  0 0 1  0 0 255 255  0 1\n3 0 1 2\n";
  const SoupLooks looks = read_text(text, "a.off").looks;
  EXPECT_EQ(looks.colours, (std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}}));
  EXPECT_EQ(looks.places, (std::vector<PicturePlace>{{0, 0.5}, {1, 0.5}, {0, 1}}));
}

TEST(ReadOff, TellsOfNumbersOfATableOfColours) {
  const SoupLooks looks = read_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n", "a.off").looks;
  EXPECT_TRUE(looks.empty());
  EXPECT_TRUE(looks.has_colour_numbers);
}

}  // namespace
}  // namespace foldwright::testing
