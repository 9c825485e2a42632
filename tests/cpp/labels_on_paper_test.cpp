#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include "geometry/convex2.h"
#include "meshes.h"
#include "nets.h"
#include "paper/labels.h"
#include "paper/seam_ids.h"

namespace foldwright::testing {
namespace {

/// Labels of nets that are named by letters.
LabelPlan labelled(const std::vector<Net>& nets, const std::vector<std::vector<Flap>>& flaps,
                   IdPlace place, const std::vector<int>& tape = {}) {
  std::vector<std::string> names;
  for (std::size_t n = 0; n < nets.size(); ++n) names.push_back(piece_letter(static_cast<int>(n)));
  return place_labels({nets, flaps, names, place, tape});
}

/// The ink of a label, as narrow as usual faces are.
std::vector<Vec2> ink(const Label& label) {
  const Vec2 along(std::cos(label.angle), std::sin(label.angle));
  const Vec2 up(-along.y(), along.x());
  const Vec2 x = 0.5 * 0.56 * static_cast<double>(label.text.size()) * label.size * along;
  const Vec2 y = 0.5 * kCapHeight * label.size * up;
  const Vec2& c = label.centre;
  return {c - x - y, c + x - y, c + x + y, c - x + y};
}

/// Whether the segment passes through the polygon, by sampling it finely.
bool crosses(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  for (int i = 0; i <= 400; ++i) {
    const Vec2 p = a + i / 400.0 * (b - a);
    bool inside = true;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2& from = polygon[k];
      inside = inside && cross(polygon[(k + 1) % polygon.size()] - from, p - from) > 0;
    }
    if (inside) return true;
  }
  return false;
}

bool is_inside(std::span<const Vec2> polygon, const Vec2& p) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& from = polygon[k];
    if (cross(polygon[(k + 1) % polygon.size()] - from, p - from) < 0) return false;
  }
  return true;
}

/// Whether a point lies on one of the faces or flaps.
bool is_on(const Net& net, const std::vector<Flap>& flaps, const Vec2& p) {
  return std::ranges::any_of(
             net.corners,
             [&](const std::array<int, 3>& face) {
               const auto& [a, b, c] = face;
               return is_inside(std::array{net.vertices[a], net.vertices[b], net.vertices[c]}, p);
             }) ||
         std::ranges::any_of(flaps, [&](const Flap& flap) { return is_inside(flap.corners, p); });
}

void expect_clear(const Net& net, const std::vector<Flap>& flaps,
                  const std::vector<Label>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::vector<Vec2> box = ink(labels[i]);
    EXPECT_TRUE(is_on(net, flaps, labels[i].centre)) << labels[i].text;
    EXPECT_GT(labels[i].angle, -1.5707963268);
    EXPECT_LE(labels[i].angle, 1.5707963268);
    for (const NetEdge& edge : net.edges) {
      if (edge.assignment == Assignment::kFlat) continue;
      EXPECT_FALSE(crosses(box, net.vertices[edge.vertices[0]], net.vertices[edge.vertices[1]]))
          << labels[i].text;
    }
    for (const Flap& flap : flaps) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_FALSE(crosses(box, flap.corners[k], flap.corners[k + 1])) << labels[i].text;
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(convex_overlap(box, ink(labels[j]), 0)) << labels[i].text;
    }
    for (const Label& other : labels) {
      if (!other.leader) continue;
      EXPECT_FALSE(crosses(box, other.leader->from, other.leader->to)) << labels[i].text;
    }
  }
}

TEST(PieceLetter, CountsLikeTheColumnsOfATable) {
  const std::pair<int, const char*> cases[] = {{0, "A"},   {25, "Z"},   {26, "AA"},
                                               {51, "AZ"}, {701, "ZZ"}, {702, "AAA"}};
  for (const auto& [index, letters] : cases) EXPECT_EQ(piece_letter(index), letters);
}

TEST(PlaceLabels, KeepOffLinesAndEachOther) {
  for (const int faces : {60, 300}) {
    SCOPED_TRACE(faces);
    const Mesh mesh = bumpy_sphere(faces);
    const std::vector<Net> nets = {net_of(mesh, 150)};
    const FlapPlan flaps = place_flaps(mesh, nets, {});
    for (const IdPlace place : {IdPlace::kInside, IdPlace::kFlap, IdPlace::kBoth}) {
      const LabelPlan plan = labelled(nets, flaps.flaps, place);
      expect_clear(nets[0], flaps.flaps[0], plan.labels[0]);
      EXPECT_GT(plan.printed, 0);
    }
  }
}

TEST(PlaceLabels, KeepOnNarrowFlaps) {
  // At this size many flaps are lower and narrower than the texts of their edges.
  const Mesh mesh = bumpy_sphere(300);
  const std::vector<Net> nets = {net_of(mesh, 75)};
  const FlapPlan flaps = place_flaps(mesh, nets, {});
  const LabelPlan plan = labelled(nets, flaps.flaps, IdPlace::kFlap);
  expect_clear(nets[0], flaps.flaps[0], plan.labels[0]);
}

TEST(PlaceLabels, WriteEachIdAtBothSidesOrListIt) {
  const Mesh mesh = bumpy_sphere(300);
  const std::vector<Net> nets = {net_of(mesh, 100)};
  const FlapPlan flaps = place_flaps(mesh, nets, {});
  const LabelPlan plan = labelled(nets, flaps.flaps, IdPlace::kInside);
  std::map<std::string, int> uses;
  for (const Label& label : plan.labels[0]) ++uses[label.text];
  const std::set<std::string> skipped(plan.skipped.begin(), plan.skipped.end());
  const int seams = plan.printed + static_cast<int>(skipped.size());
  for (int id = 1; id <= seams; ++id) {
    const int count = uses[std::to_string(id)];
    if (skipped.contains("A:" + std::to_string(id))) {
      EXPECT_LT(count, 2) << id;
    } else {
      EXPECT_EQ(count, 2) << id;
    }
  }
  EXPECT_GT(plan.printed, seams / 2);
}

TEST(PlaceLabels, LeadToEdgesWithoutRoomBesideThem) {
  const Mesh mesh = bumpy_sphere(600);
  const std::vector<Net> nets = {net_of(mesh, 90)};
  const FlapPlan flaps = place_flaps(mesh, nets, {});
  const LabelPlan plan = labelled(nets, flaps.flaps, IdPlace::kBoth);
  expect_clear(nets[0], flaps.flaps[0], plan.labels[0]);
  int led = 0;
  for (const Label& label : plan.labels[0]) {
    if (!label.leader) continue;
    ++led;
    // The line ends at the middle of a cut edge, on its inner side.
    const Vec2 end = label.leader->to;
    EXPECT_TRUE(std::ranges::any_of(nets[0].edges, [&](const NetEdge& edge) {
      const Vec2 a = nets[0].vertices[edge.vertices[0]];
      const Vec2 b = nets[0].vertices[edge.vertices[1]];
      const bool is_left = cross(b - a, end - a) > 0;
      return edge.assignment == Assignment::kCut && is_left && (0.5 * (a + b) - end).norm() < 0.3;
    })) << label.text;
  }
  EXPECT_GT(led, 0);
}

TEST(PlaceLabels, MarkBothSidesForTape) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const std::vector<std::vector<Flap>> none(1);
  const int edge = find_seams(nets)[2].mesh_edge();
  const LabelPlan plan = labelled(nets, none, IdPlace::kBoth, {edge});
  EXPECT_EQ(plan.tape_marks[0].size(), 4u);
  for (const Stroke& mark : plan.tape_marks[0]) {
    for (const Label& label : plan.labels[0]) {
      EXPECT_FALSE(crosses(ink(label), mark.from, mark.to)) << label.text;
    }
  }
}

TEST(NameSeams, CountsAlongTheOutline) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const std::vector<std::string> names = {"A"};
  std::set<std::string> texts;
  for (const SeamId& id : name_seams(nets, names, find_seams(nets))) {
    EXPECT_EQ(id.texts[0], id.texts[1]);
    EXPECT_EQ(id.name, "A:" + id.texts[0]);
    texts.insert(id.texts[0]);
  }
  EXPECT_EQ(texts, (std::set<std::string>{"1", "2", "3", "4", "5", "6", "7"}));
}

TEST(NameSeams, CountsForEachPairOfPieces) {
  const std::vector<Net> nets = squares_of(cube());
  const std::vector<std::string> names = {"A", "Lid", "C2", "D", "E", "F"};
  const std::vector<Seam> seams = find_seams(nets);
  const std::vector<SeamId> ids = name_seams(nets, names, seams);
  std::set<std::string> all;
  ASSERT_EQ(ids.size(), 12u);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    all.insert(ids[i].name);
    EXPECT_EQ(ids[i].name,
              names[seams[i].sides[0].net] + "-" + names[seams[i].sides[1].net] + ":1");
    for (const int s : {0, 1}) {
      const std::string& met = names[seams[i].sides[1 - s].net];
      // Only letters alone go before a number without a sign between them.
      EXPECT_EQ(ids[i].texts[s], met.size() == 1 ? met + "1" : met + ":1");
    }
  }
  EXPECT_EQ(all.size(), 12u);
}

TEST(PlaceLabels, NameTheOtherPiece) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = squares_of(cube());
  const FlapPlan flaps = place_flaps(mesh, nets, {});
  const LabelPlan plan = labelled(nets, flaps.flaps, IdPlace::kInside);
  EXPECT_EQ(plan.printed, 12);
  for (std::size_t n = 0; n < nets.size(); ++n) {
    const std::string own = piece_letter(static_cast<int>(n));
    EXPECT_EQ(plan.labels[n][0].text, own);
    ASSERT_EQ(plan.labels[n].size(), 5u);
    for (std::size_t i = 1; i < 5; ++i) {
      const std::string& text = plan.labels[n][i].text;
      const std::size_t other = static_cast<std::size_t>(text[0] - 'A');
      EXPECT_EQ(text.substr(1), "1") << "the only seam of the two";
      EXPECT_NE(other, n);
      const std::string back = own + text.substr(1);
      EXPECT_TRUE(std::ranges::any_of(plan.labels[other],
                                      [&](const Label& label) { return label.text == back; }));
    }
  }
}

TEST(PlaceLabels, TurnANameWithoutRoomElse) {
  const std::vector<std::string> names = {"Left wing"};
  for (const double angle : {0.5, 1.3, 2.1, 4.0}) {
    SCOPED_TRACE(angle);
    // A face 12 mm high over a side of 42 mm.
    const Mesh mesh = tetrahedron();
    std::vector<Net> nets = {
        make_net(mesh, restrict_to(build_dual_graph(mesh), std::array{0}), {})};
    nets[0].vertices = {Vec2(0, 0), Vec2(42, 0), Vec2(20, 12)};
    for (Vec2& p : nets[0].vertices) p = Eigen::Rotation2Dd(angle) * p;
    const std::vector<std::vector<Flap>> none(1);
    const LabelPlan plan = place_labels({nets, none, names, IdPlace::kNone, {}});
    ASSERT_EQ(plan.labels[0].size(), 1u);
    EXPECT_EQ(plan.labels[0][0].text, names[0]);
    EXPECT_NEAR(std::remainder(plan.labels[0][0].angle - angle, std::numbers::pi), 0, 1e-9);
    expect_clear(nets[0], {}, plan.labels[0]);
  }
}

TEST(PlaceLabels, LeaveOutWhatNobodyCouldRead) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 3)};
  const std::vector<std::vector<Flap>> none(1);
  const LabelPlan plan = labelled(nets, none, IdPlace::kBoth);
  EXPECT_TRUE(plan.labels[0].empty());
  EXPECT_EQ(plan.printed, 0);
  EXPECT_EQ(plan.skipped.size(), 7u);
}

}  // namespace
}  // namespace foldwright::testing
