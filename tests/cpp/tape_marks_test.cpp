#include "paper/tape_marks.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

TEST(TapeMarks, MeetWhenTheEdgesComeTogether) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  LabelSpace space(nets[0], {});
  for (const Seam& seam : find_seams(nets)) {
    const auto marks = tape_marks(seam, {&space, &space});
    ASSERT_EQ(marks[0].size(), 2u);
    ASSERT_EQ(marks[1].size(), 2u);
    for (const int i : {0, 1}) {
      const Vec2 here = seam.sides[0].local(marks[0][i].from);
      const Vec2 there = seam.sides[1].local(marks[1][1 - i].from);
      EXPECT_NEAR(here.x(), seam.sides[1].length() - there.x(), 1e-9);
      EXPECT_LT(here.y(), 0) << "on the face";
      EXPECT_LT(seam.sides[0].local(marks[0][i].to).y(), here.y());
    }
  }
}

TEST(TapeMarks, MoveAlongTheEdgeOutOfTheWayOfTexts) {
  const std::vector<Net> nets = {net_of(cube(), 80)};
  LabelSpace space(nets[0], {});
  const Seam seam = find_seams(nets)[0];
  const SeamSide& side = seam.sides[0];
  const Vec2 along = (side.to - side.from).normalized();
  space.take(TextBox{side.global({20, -1}), along, 6, 0.9});
  const auto marks = tape_marks(seam, {&space, &space});
  ASSERT_EQ(marks[0].size(), 2u);
  for (const Stroke& mark : marks[0]) EXPECT_GT(std::abs(side.local(mark.from).x() - 20), 6);
  space.take(TextBox{side.global({20, -1}), along, 19.9, 0.9});
  EXPECT_TRUE(tape_marks(seam, {&space, &space})[0].empty());
}

}  // namespace
}  // namespace foldwright::testing
