#include <gtest/gtest.h>

#include <cmath>

#include "model_text.h"

namespace foldwright::testing {
namespace {

using Corners = std::vector<int>;

// Four corners of the unit square.
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, TakesPositionsAndFaces) {
  const PolygonSoup soup = read_text(kSquare + "f 1 2 3 4\nf 4 3 2\n", "square.obj");
  EXPECT_EQ(soup.positions.size(), 4u);
  ASSERT_EQ(soup.face_count(), 2);
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(corners_of(soup, 1), (Corners{3, 2, 1}));
  EXPECT_TRUE(soup.repairs.empty());
}

TEST(ReadObj, TakesOnlyTheVertexOfACorner) {
  for (const char* face : {"f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/1/1 2/2/2 3/3/3", "f 1/ 2/ 3/",
                           "f\t1\t2\t3", "f -4 -3 -2", "f -4/-1 -3/-2 -2/-3"}) {
    const PolygonSoup soup = read_text(kSquare + face + "\n", "square.obj");
    EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2})) << face;
  }
}

TEST(ReadObj, CountsNegativeIndicesFromTheVerticesBefore) {
  const PolygonSoup soup = read_text(kSquare + "f -4 -3 -2\nv 5 5 5\nf -2 -1 1\n", "square.obj");
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners_of(soup, 1), (Corners{3, 4, 0}));
}

TEST(ReadObj, AllowsVerticesAfterTheirFace) {
  EXPECT_EQ(read_text("f 1 2 3 4\n" + kSquare, "square.obj").face_count(), 1);
}

TEST(ReadObj, SkipsWhatIsNoFace) {
  const std::string rest =
      "# comment\nmtllib a.mtl\nvt 0 0\nvn 0 0 x\nusemtl # 1\ns off\nvp 0.5\nf 1 2 3\n";
  const PolygonSoup soup = read_text(kSquare + rest, "square.obj");
  EXPECT_EQ(soup.face_count(), 1);
  EXPECT_TRUE(soup.repairs.empty());
}

TEST(ReadObj, IgnoresWeightsAndColours) {
  const PolygonSoup soup =
      read_text("v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv 7 8 9\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(soup.positions[1], Vec3(4, 5, 6));
}

TEST(ReadObj, GoesOnAfterABackslash) {
  EXPECT_EQ(corners_of(read_text(kSquare + "f 1 2 \\\r\n 3 4\n", "a.obj"), 0),
            (Corners{0, 1, 2, 3}));
}

TEST(ReadObj, KeepsFacesThatAreTooShortForTheReport) {
  EXPECT_EQ(read_text(kSquare + "f 1 2 3\nf 1\nf\n", "a.obj").face_count(), 3);
}

/// The square and a face of it, and what else is said about that file.
std::vector<std::string> repairs_of(const std::string& rest) {
  return repairs_told(read_text(kSquare + "f 1 2 3\n" + rest, "a.obj"));
}

TEST(ReadObj, DropsOnlyTheFacesThatAFaultTouches) {
  using Told = std::vector<std::string>;
  for (const char* face : {"f 1 2 99", "f 0 1 4", "f -1 -2 -9", "f 1 x 3"}) {
    EXPECT_EQ(repairs_of(face + std::string("\n")),
              Told{"dropped-misnumbered-faces count=1 place=line at=6"})
        << face;
  }
  EXPECT_EQ(repairs_of("v 0 nan 0\nf 1 2 5\nf 2 3 4\nv x 0 0\n"),
            Told{"dropped-placeless-faces count=1 place=line at=6"});
  EXPECT_EQ(repairs_of("v 1 2\nf 1 2 5\n"),
            Told{"dropped-placeless-faces count=1 place=line at=6"});
  EXPECT_EQ(repairs_of("f 1 2"), Told{"cut-off count=1 place=line at=6"});
}

TEST(ReadObj, KeepsNumbersAndLooksOfFacesBesideADroppedOne) {
  const PolygonSoup soup = read_text(
      kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 9/2 3/3\nf 3/3 4/1 1/2\n", "a.obj");
  EXPECT_EQ(soup.face_count(), 3);
  EXPECT_EQ(soup.unusable_faces, 1);
  EXPECT_TRUE(corners_of(soup, 1).empty());
  EXPECT_EQ(corners_of(soup, 2), (Corners{2, 3, 0}));
  const std::vector<PicturePlace> places = {{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}, {1, 0}};
  EXPECT_EQ(soup.looks.places, places);
}

TEST(ReadObj, RefusesAFileOfWhichMostIsWrong) {
  EXPECT_EQ(refusal(kSquare + "f 1 2 3\nf 7 2 3\nf 8 2 3\n", "a.obj"),
            "bad-index place=line at=6 what=beyond index=7 vertices=4 first=1");
}

TEST(ReadObj, TakesVerticesThatAreCountedFromZero) {
  const PolygonSoup soup = read_text(
      kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 0/0 1/1 2/2\nf 0/0 2/2 3/3\n", "a.obj");
  EXPECT_EQ(repairs_told(soup), std::vector<std::string>{"counts-from-zero count=2"});
  EXPECT_EQ(corners_of(soup, 1), (Corners{0, 2, 3}));
  const std::vector<PicturePlace> places = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(soup.looks.places, places);
}

TEST(ReadObj, TakesASlipInAFileWithAnUnusedVertexForNoOtherCount) {
  const PolygonSoup soup = read_text(kSquare + "v 9 9 9\nf 1 2 4\nf 1 2 4\nf 0 1 2\n", "a.obj");
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 3}));
  EXPECT_EQ(soup.unusable_faces, 1);
}

TEST(ReadObj, TakesDecimalCommas) {
  const PolygonSoup soup = read_text("v 1,5 -0,25 3\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(soup.positions[0], Vec3(1.5, -0.25, 3));
  EXPECT_EQ(repairs_told(soup), std::vector<std::string>{"decimal-commas count=2"});
}

TEST(ReadObj, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(refusal(kSquare + "f 1 2 99\n", "a.obj"),
            "bad-index place=line at=5 what=beyond index=99 vertices=4 first=1");
  EXPECT_EQ(refusal(kSquare + "f 0 1 2\n", "a.obj"),
            "bad-index place=line at=5 what=beyond index=0 vertices=4 first=1");
  EXPECT_EQ(refusal(kSquare + "\nf -1 -2 -5\n", "a.obj"),
            "bad-index place=line at=6 what=before index=-5 vertices=4");
  EXPECT_EQ(refusal("v 0 0 nan\nf 1 1 1\n", "a.obj"), "not-finite place=line at=1 what=coordinate");
  EXPECT_EQ(refusal("v 0 0 0\nv 1,5,5 0 0\nf 1 2 2\n", "a.obj"),
            "bad-number place=line at=2 what=comma word=1,5,5");
  EXPECT_EQ(refusal("v 0 0 0\nv 1 2\n", "a.obj"), "truncated place=line at=2 what=coordinates");
  EXPECT_EQ(refusal(kSquare + "f 1 2 x\n", "a.obj"),
            "bad-number place=line at=5 what=whole word=x");
  EXPECT_EQ(refusal(kSquare + "f 1 2", "a.obj"), "truncated place=line at=5 what=face");
}

TEST(ReadObj, RefusesPointsAndLinesAlone) {
  EXPECT_EQ(refusal(kSquare + "p 1\nl 1 2\n", "a.obj"), "no-faces what=vertices");
}

TEST(ReadObj, TellsHowFarCoordinatesWereRounded) {
  EXPECT_DOUBLE_EQ(
      read_text("v 0 1.41202 0.53934\nv 0.5 0 0\nv 0 0 1 0.123456789\nf 1 2 3\n", "a.obj")
          .precision,
      5e-6);
}

TEST(ReadObj, ReportsShapesThatAreNoFaces) {
  const PolygonSoup soup = read_text(
      kSquare + "f 1 2 3\np 1\nl 1 99\nl 1 2\ncurv 0 1 1 2\ncurv2 1 2\nsurf 0 1 0 1 1 2 3 4\n",
      "square.obj");
  EXPECT_EQ(soup.face_count(), 1);
  EXPECT_EQ(repair_named(soup.repairs, "ignored-elements").count, 6);
  EXPECT_EQ(describe(message_of(repair_named(soup.repairs, "ignored-elements"))),
            "ignored-elements count=6 points=1 lines=2 curves=2 surfaces=1");
  EXPECT_EQ(refusal(kSquare + "surf 0 1 0 1 1 2 3 4\n", "square.obj"), "no-faces what=surfaces");
}

TEST(ReadObj, TakesNumbersInEverySpelling) {
  const PolygonSoup soup =
      read_text("v\t1. .5 1e1 \t\nv +1 -.5e0 1E-2\nv 0 0 0 1\nf  1/2/3   2//4\t3/5 \n", "a.obj");
  EXPECT_EQ(soup.positions[0], Vec3(1, 0.5, 10));
  EXPECT_EQ(soup.positions[1], Vec3(1, -0.5, 0.01));
  EXPECT_EQ(corners_of(soup, 0), (Corners{0, 1, 2}));
}

constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
constexpr const char* kPlaces = "vt 0 0\nvt 1 0\nvt 0 1 0\n";

TEST(ReadObj, KnowsWhichLooksAFileHas) {
  const std::string corners = kCorners;
  const std::string places = kPlaces;
  const std::pair<std::string, const char*> cases[] = {
      {corners + "f 1 2 3\n", ""},
      {corners + places + "vn 0 0 1\nf 1//1 2//1 3//1\n", ""},
      {"v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", ""},
      {"mtllib a.mtl\n" + corners + "f 1 2 3\n", ""},
      {corners + "usemtl red\nf 1 2 3\n", "materials"},
      {"v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n", "colours"},
      {corners + places + "f 1/1 2/2 3/3\n", "places"},
      {corners + places + "usemtl a\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n", "places materials"}};
  for (const auto& [text, looks] : cases) {
    EXPECT_EQ(looks_of(read_text(text, "a.obj")), looks) << text;
  }
}

TEST(ReadObj, ReadsPlacesInPicturesByNumberAndBackwards) {
  const SoupLooks looks =
      read_text(kCorners + std::string(kPlaces) + "f 1/1 2/-2 3/3\nf 1/2 3/1 2\n", "a.obj").looks;
  const PicturePlace known[] = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}};
  ASSERT_EQ(looks.places.size(), 6u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(looks.places[i], known[i]) << i;
  EXPECT_TRUE(std::isnan(looks.places[5][0])) << "a corner that names none has none";
}

TEST(ReadObj, CountsPlacesThatAreNot) {
  for (const char* word : {"9", "-9", "x", "0"}) {
    const std::string face = "f 1/1 2/" + std::string(word) + " 3/3\n";
    const PolygonSoup soup = read_text(kCorners + std::string(kPlaces) + face, "a.obj");
    EXPECT_EQ(repair_named(soup.repairs, "lost-picture-places").count, 1) << word;
    EXPECT_TRUE(std::isnan(soup.looks.places[1][0])) << word;
    EXPECT_EQ(soup.looks.places[2], (PicturePlace{0, 1})) << word;
  }
  // Places may come after the faces that name them.
  const PolygonSoup late = read_text(kCorners + std::string("f 1/1 2/2 3/3\n") + kPlaces, "a.obj");
  EXPECT_EQ(repair_named(late.repairs, "lost-picture-places").count, 0);
  EXPECT_EQ(late.looks.places[1], (PicturePlace{1, 0}));
}

TEST(ReadObj, NumbersMaterialsByName) {
  const SoupLooks looks =
      read_text(
          kCorners + std::string("mtllib my file.mtl other.mtl\nf 1 2 3\nusemtl red # 1 \nf 1 3 2\n"
                                 "usemtl blue\nf 1 2 3\nusemtl red # 1\nf 1 2 3\n"),
          "a.obj")
          .looks;
  EXPECT_EQ(looks.materials, (std::vector<int>{-1, 0, 1, 0}));
  EXPECT_EQ(looks.material_names, (std::vector<std::string>{"red # 1", "blue"}));
  EXPECT_EQ(looks.libraries, (std::vector<std::string>{"my file.mtl other.mtl"}));
}

TEST(ReadObj, ReadsColoursOfVerticesUpToOneOrTo255) {
  for (const char* full : {"1", "255"}) {
    const std::string one = full;
    const SoupLooks looks =
        read_text("v 0 0 0 " + one + " 0 0\nv 1 0 0 0 " + one + " 0 1\nv 0 1 0\nf 1 2 3\n", "a.obj")
            .looks;
    // A vertex without a colour is as white as paper.
    EXPECT_EQ(looks.colours, (std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {255, 255, 255}}));
  }
}

}  // namespace
}  // namespace foldwright::testing
