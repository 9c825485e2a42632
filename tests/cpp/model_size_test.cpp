#include "pipeline/sheets/model_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/input_error.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

Mesh cube_of(double side) {
  Mesh mesh = cube();
  for (Vec3& p : mesh.positions) p *= side;
  return mesh;
}

TEST(ModelUnit, IsTheSmallestInWhichTheModelIsLargeEnough) {
  EXPECT_EQ(model_unit(cube_of(150), Unit::kGuess).unit, Unit::kMillimetre);
  EXPECT_EQ(model_unit(cube_of(15), Unit::kGuess).unit, Unit::kCentimetre);
  EXPECT_EQ(model_unit(cube_of(1), Unit::kGuess).unit, Unit::kMetre);
  EXPECT_TRUE(model_unit(cube_of(1), Unit::kGuess).guessed);
}

TEST(ModelUnit, IsTheOneAskedFor) {
  EXPECT_EQ(model_unit(cube_of(1), Unit::kInch).unit, Unit::kInch);
  EXPECT_FALSE(model_unit(cube_of(1), Unit::kInch).guessed);
}

TEST(FixedScale, GivesTheModelTheSizeAskedFor) {
  Mesh mesh = cube_of(2);
  for (Vec3& p : mesh.positions) p.y() *= 3;
  EXPECT_DOUBLE_EQ(fixed_scale(mesh, {Sizing::kHeight, 150}), 25);
  EXPECT_DOUBLE_EQ(fixed_scale(mesh, {Sizing::kWidth, 150}), 75);
  for (Vec3& p : mesh.positions) p.z() *= 2;
  EXPECT_DOUBLE_EQ(fixed_scale(mesh, {Sizing::kDepth, 150}), 37.5);
  EXPECT_DOUBLE_EQ(fixed_scale(mesh, {Sizing::kScale, 0.5, Unit::kInch}), 12.7);
}

TEST(FixedScale, RefusesADirectionWithoutExtent) {
  const Mesh flat = open_strip(2);
  Mesh lying = flat;
  for (Vec3& p : lying.positions) p = Vec3(p.x(), 0, p.y());
  try {
    fixed_scale(lying, {Sizing::kHeight, 150});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "no-height");
  }
}

TEST(LargestPartArea, GoesWithTheSheetAndTheSize) {
  const Mesh mesh = cube_of(2);
  JobOptions options;
  for (const Sizing by : {Sizing::kFit, Sizing::kSheets}) {
    options.paper.size = {by, 2};
    EXPECT_TRUE(std::isinf(largest_part_area(mesh, options.paper)));
  }
  options.paper.size = {Sizing::kHeight, 100};
  const double area = largest_part_area(mesh, options.paper);
  const Extent room = printable(options.paper.sheet);
  const double share = area * 50 * 50 / (room.width * room.height);
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.8);
  options.paper.size.value = 200;
  EXPECT_DOUBLE_EQ(largest_part_area(mesh, options.paper), area / 4);
}

}  // namespace
}  // namespace foldwright::testing
