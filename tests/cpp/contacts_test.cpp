#include "paper/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craft_shapes.h"
#include "job_runs.h"

namespace foldwright::testing {
namespace {

Solid box_at(const Vec3& low, const Vec3& size) {
  Solid box = grid_cube_of(1, 1);
  for (Vec3& p : box.positions) p = low + p.cwiseProduct(size);
  return box;
}

/// A chest of 60 mm with two studs of 6 mm: one on its top, one beside it in the air.
std::string chest_with_studs() {
  return obj_of(together("chest", {box_at({0, 0, 0}, {60, 60, 60}), box_at({10, 60, 20}, {8, 6, 8}),
                                   box_at({100, 0, 0}, {8, 6, 8})}));
}

Outcome run_chest(IdPlace ids = IdPlace::kFlap) {
  JobOptions options;
  options.paper.size = {Sizing::kScale, 1, Unit::kMillimetre};
  options.paper.ids = ids;
  return run_file(chest_with_studs(), "chest.obj", options);
}

TEST(Contacts, AreDrawnWhereABodyStands) {
  const Outcome outcome = run_chest();
  expect_sound(outcome);
  const std::vector<Piece>& pieces = outcome.result->pieces;
  ASSERT_EQ(pieces.size(), 3u);
  double length = 0;
  int with_lines = 0;
  for (const Piece& piece : pieces) {
    with_lines += !piece.joint_lines.empty();
    for (const Stroke& line : piece.joint_lines) length += (line.to - line.from).norm();
  }
  EXPECT_EQ(with_lines, 1);
  EXPECT_NEAR(length, 4 * 8, 1e-6);
  EXPECT_FALSE(pieces[0].joint_lines.empty()) << "the chest is the largest piece";
}

TEST(Contacts, HaveTheNameOfWhatStandsThere) {
  const Outcome outcome = run_chest();
  ASSERT_TRUE(outcome.result);
  const Piece& chest = outcome.result->pieces[0];
  int names = 0;
  for (const Label& label : chest.labels) {
    const bool is_other = label.text == outcome.result->pieces[1].name ||
                          label.text == outcome.result->pieces[2].name;
    if (!is_other) continue;
    ++names;
    Vec2 middle = Vec2::Zero();
    for (const Stroke& line : chest.joint_lines) middle += 0.125 * (line.from + line.to);
    EXPECT_NEAR((label.centre - middle).norm(), 0, 1e-6);
  }
  EXPECT_EQ(names, 1);
}

TEST(Contacts, AreThoseOfLargerBodies) {
  const Mesh apart = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {0, 1, 2}, {1, 0, 2}},
                               {{0, 1, 2}, {3, 4, 5}});
  EXPECT_TRUE(find_contacts(apart, build_dual_graph(apart)).empty());
  // A small triangle face to face with a large one.
  const Mesh touching = make_mesh(
      {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const auto contacts = find_contacts(touching, build_dual_graph(touching));
  ASSERT_EQ(contacts.size(), 3u);
  for (const Contact& contact : contacts) {
    EXPECT_EQ(contact.host, 0);
    EXPECT_EQ(contact.guest, 1);
  }
}

TEST(Contacts, AreDrawnOnceOnADiagonalAndNotOnTheRimOfTheHost) {
  // A square of two triangles, and on it a triangle with a side on the diagonal and one on the rim.
  const Mesh mesh = make_mesh(
      {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {2, 2, 0}, {5, 5, 0}, {8, 2, 0}, {8, 5, 0}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}});
  const DualGraph graph = build_dual_graph(mesh);
  ASSERT_EQ(graph.panel_count(), 2);
  double on_diagonal = 0;
  for (const Contact& contact : find_contacts(mesh, graph)) {
    EXPECT_FALSE(contact.from.x() > 7.9 && contact.to.x() > 7.9);
    const bool lies_there = std::abs(contact.from.x() - contact.from.y()) < 1e-3 &&
                            std::abs(contact.to.x() - contact.to.y()) < 1e-3;
    if (lies_there) on_diagonal += (contact.to - contact.from).norm();
  }
  EXPECT_NEAR(on_diagonal, std::sqrt(18), 1e-4);
}

TEST(Contacts, AreCutWhereTheHostEnds) {
  const Mesh mesh = make_mesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {-1, 1, 0}, {-1, 2, 0}, {1, 1, 0}},
                              {{0, 1, 2}, {3, 4, 5}});
  for (const Contact& contact : find_contacts(mesh, build_dual_graph(mesh))) {
    EXPECT_GE(std::min(contact.from.x(), contact.to.x()), -1e-9);
  }
}

}  // namespace
}  // namespace foldwright::testing
