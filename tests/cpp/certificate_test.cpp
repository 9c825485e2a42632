#include "fold/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "drawn_shapes.h"
#include "folding.h"
#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

using State = Certificate::State;

constexpr std::int64_t kToTheEnd = std::numeric_limits<std::int64_t>::max();
constexpr double kPi = std::numbers::pi;

State judge(const Foldable& foldable, const FoldTree& folds, const Leg& leg) {
  Certificate certificate(foldable, folds, leg);
  return certificate.step(kToTheEnd);
}

FoldTree all_hinges(const DualGraph& graph) {
  FoldTree folds;
  for (int h = 0; h < graph.hinge_count(); ++h) folds.push_back(h);
  return folds;
}

std::vector<Mesh> varied_meshes(std::uint64_t seed) {
  return {cube(),      tetrahedron(),         star(),           torus(6, 5),
          l_prism(),   random_hull(seed, 25), bumpy_sphere(60), accordion({1, 2, 1, 3, 1, 1}),
          saddle(8, 7)};
}

/// A leg between shapes in which each hinge has a random share of its angle, and beyond.
Leg random_leg(const DualGraph& graph, Random& random) {
  Leg leg;
  const bool from_flat = random.below(2) == 0;
  // Short legs are certified more often.
  const double reach = random.below(2) == 0 ? 1 : 0.1;
  for (const Hinge& hinge : graph.hinges) {
    const double from = from_flat ? 0 : random.uniform();
    leg.from.push_back(from * hinge.angle);
    leg.to.push_back((from + reach * (1.2 * random.uniform() - 0.1)) * hinge.angle);
  }
  return leg;
}

/// What the certificate says against samples of a plain check of all pairs.
struct Comparison {
  int certified = 0;
  int refuted = 0;
  int refuted_without_a_sample = 0;
};

void compare(const Mesh& mesh, const DualGraph& graph, const FoldTree& folds, const Leg& leg,
             Comparison& comparison) {
  const Foldable foldable = make_foldable(graph);
  Certificate certificate(foldable, folds, leg);
  const State state = certificate.step(kToTheEnd);
  const PlainFolder folder(mesh, graph, folds);
  const auto times = colliding_times(folder, leg.from, leg.to, 400);
  if (!times.empty()) {
    EXPECT_EQ(state, State::kRefuted) << "faces collide at " << times[0];
  }
  if (state == State::kCertified) {
    ++comparison.certified;
    EXPECT_TRUE(certificate.counterexamples().empty());
    EXPECT_EQ(certificate.progress(), 1);
    return;
  }
  ++comparison.refuted;
  const auto& found = certificate.counterexamples();
  EXPECT_FALSE(found.empty());
  const bool seen = !times.empty() || std::ranges::any_of(found, [&](double s) {
    return folder.collides(between(leg.from, leg.to, s));
  });
  comparison.refuted_without_a_sample += seen ? 0 : 1;
}

TEST(Certificate, AgreesWithSamplesOfAPlainCheckOfAllPairs) {
  Comparison comparison;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : varied_meshes(seed)) {
      SCOPED_TRACE(mesh.face_count());
      const DualGraph graph = build_dual_graph(mesh);
      const FoldTree folds = random_tree(graph, random);
      compare(mesh, graph, folds, straight_leg(graph), comparison);
      compare(mesh, graph, folds, random_leg(graph, random), comparison);
    }
  }
  EXPECT_GT(comparison.certified, 40);
  EXPECT_GT(comparison.refuted, 40);
  // Faces may touch between the samples, or come nearer than any bound tells, but rarely do.
  EXPECT_LE(comparison.refuted_without_a_sample, 2);
}

TEST(Certificate, AgreesWithSamplesOnNets) {
  // Nets are where certificates are asked for: most of the way is free, if not all of it.
  Comparison comparison;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    for (const Mesh& mesh : {star(), bumpy_sphere(100), torus(8, 6), random_hull(seed, 30)}) {
      SCOPED_TRACE(mesh.face_count());
      const DualGraph graph = build_dual_graph(mesh);
      const FoldTree folds = searched_net(mesh, graph, seed, 0);
      if (folds.empty()) continue;
      compare(mesh, graph, folds, straight_leg(graph), comparison);
    }
  }
  EXPECT_GT(comparison.certified, 4);
  EXPECT_GT(comparison.refuted, 4);
  EXPECT_LE(comparison.refuted_without_a_sample, 1);
}

/// Angles of a row of panels, all the same.
std::vector<double> even(const DualGraph& row, double angle) {
  return std::vector<double>(row.hinges.size(), angle);
}

TEST(Certificate, RefusesAStripThatRollsThroughItself) {
  const DualGraph strip = build_dual_graph(accordion(std::vector<double>(12, 1)));
  const Foldable foldable = make_foldable(strip);
  const FoldTree folds = all_hinges(strip);
  const double round = 2 * kPi / 12;
  EXPECT_EQ(judge(foldable, folds, {even(strip, 0), even(strip, 0.9 * round)}), State::kCertified);
  EXPECT_EQ(judge(foldable, folds, {even(strip, 0), even(strip, 1.5 * round)}), State::kRefuted);
  EXPECT_EQ(judge(foldable, folds, {even(strip, 0), even(strip, -1.5 * round)}), State::kRefuted);
}

/// A base of width 1 with an arm at either end, as wide as they say.
struct Arms {
  Mesh mesh;
  DualGraph strip;

  explicit Arms(double width) : mesh(accordion({width, 1, width})), strip(build_dual_graph(mesh)) {}
};

/// Both arms lean over the base by some angles: at first one lies low and the other over it, at
/// last the other way around.
Leg changing_places(double low, double high) {
  return {{kPi - low, kPi - high}, {kPi - high, kPi - low}};
}

TEST(Certificate, FindsWhatCollidesMidwayOnly) {
  const Arms arms(0.8);
  const Foldable foldable = make_foldable(arms.strip);
  const FoldTree folds = all_hinges(arms.strip);
  const Leg leg = changing_places(0.02, 0.52);
  const PlainFolder folder(arms.mesh, arms.strip, folds);
  ASSERT_FALSE(folder.collides(leg.from));
  ASSERT_FALSE(folder.collides(leg.to));
  ASSERT_TRUE(folder.collides(between(leg.from, leg.to, 0.5)));
  Certificate certificate(foldable, folds, leg);
  EXPECT_EQ(certificate.step(kToTheEnd), State::kRefuted);
  for (const double s : certificate.counterexamples()) {
    EXPECT_TRUE(folder.collides(between(leg.from, leg.to, s)));
  }
}

TEST(Certificate, FindsWhatCollidesForAMomentOnly) {
  // Arms that just reach each other, or just do not: however short the touch, it is found.
  int certified = 0;
  int refuted = 0;
  int least_samples = 10000;
  for (int i = 0; i <= 60; ++i) {
    const Arms arms(0.55 + 0.002 * i);
    SCOPED_TRACE(i);
    const Foldable foldable = make_foldable(arms.strip);
    const FoldTree folds = all_hinges(arms.strip);
    const PlainFolder folder(arms.mesh, arms.strip, folds);
    const Leg leg = changing_places(0.2, 1);
    const auto samples = static_cast<int>(colliding_times(folder, leg.from, leg.to, 4000).size());
    const State state = judge(foldable, folds, leg);
    certified += state == State::kCertified ? 1 : 0;
    refuted += state == State::kRefuted ? 1 : 0;
    if (samples == 0) continue;
    EXPECT_EQ(state, State::kRefuted);
    least_samples = std::min(least_samples, samples);
  }
  EXPECT_GT(certified, 10);
  EXPECT_GT(refuted, 10);
  EXPECT_LT(least_samples, 400) << "none was short";
}

/// Searches a net that folds straight, has it certified anew and looks at 1001 samples of it.
void expect_to_fold_straight(const Mesh& mesh, const DualGraph& graph) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    const FoldTree folds = searched_net(mesh, graph, seed, kClearance);
    ASSERT_FALSE(folds.empty() && graph.panel_count() > 1);
    EXPECT_TRUE(is_net(mesh, graph, folds));
    EXPECT_EQ(judge(make_foldable(graph), folds, straight_leg(graph)), State::kCertified);
    const PlainFolder folder(mesh, graph, folds);
    EXPECT_TRUE(
        colliding_times(folder, fold_angles(graph, 0), fold_angles(graph, 1), 1000).empty());
  }
}

void expect_to_fold_straight(const Mesh& mesh) {
  expect_to_fold_straight(mesh, build_dual_graph(mesh));
}

TEST(Certificate, HoldsForNetsOfConvexPolyhedra) {
  for (const Mesh& mesh : {cube(), tetrahedron(), icosahedron(), random_hull(1, 30),
                           random_hull(2, 60), random_hull(3, 100)}) {
    SCOPED_TRACE(mesh.face_count());
    expect_to_fold_straight(mesh);
  }
}

TEST(Certificate, HoldsForNetsOfNonConvexModels) {
  for (const Mesh& mesh : {l_prism(), dumbbell(), bumpy_sphere(150)}) {
    SCOPED_TRACE(mesh.face_count());
    expect_to_fold_straight(mesh);
  }
}

/// The panels whose faces `keep` says yes to.
template <class Keep>
DualGraph part_of(const DualGraph& graph, Keep&& keep) {
  std::vector<int> panels;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    if (keep(graph.panel_faces(panel)[0])) panels.push_back(panel);
  }
  return restrict_to(graph, panels);
}

/// Open cylinder of radius 1: rings of quads, each in two triangles.
Mesh tube(int around, int rings) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      // Turned from ring to ring, so that no quad is flat.
      const double u = 2 * kPi * (i + 0.3 * ring) / around;
      positions.emplace_back(std::cos(u), std::sin(u), 0.6 * ring);
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const int a = ring * around + i;
      const int b = ring * around + (i + 1) % around;
      faces.push_back({a, b, b + around});
      faces.push_back({a, b + around, a + around});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

TEST(Certificate, HoldsForNetsOfATube) { expect_to_fold_straight(tube(9, 5)); }

TEST(Certificate, HoldsForNetsOfATorusInParts) {
  const Mesh mesh = torus(16, 9);
  const DualGraph graph = build_dual_graph(mesh);
  for (int part = 0; part < 4; ++part) {
    SCOPED_TRACE(part);
    expect_to_fold_straight(mesh,
                            part_of(graph, [&](int face) { return face / (4 * 9 * 2) == part; }));
  }
}

TEST(Certificate, HoldsForNetsOfAPartWithAHole) {
  // A hemisphere and more, without a cap: a ring of panels around a hole.
  const Mesh mesh = bumpy_sphere(200);
  const DualGraph graph = build_dual_graph(mesh);
  const DualGraph ring = part_of(graph, [&](int face) {
    double z = 0;
    for (const int v : mesh.faces[face]) z += mesh.positions[v].z() / 3;
    return z > -0.3 && z < 0.7;
  });
  ASSERT_GT(ring.panel_count(), 40);
  expect_to_fold_straight(mesh, ring);
}

TEST(Certificate, HoldsForFacesFoldedOntoEachOther) {
  const Mesh mesh = two_sided_square();
  const DualGraph graph = build_dual_graph(mesh);
  expect_to_fold_straight(mesh, graph);
  for (const FoldTree& folds : all_spanning_trees(graph)) {
    EXPECT_EQ(judge(make_foldable(graph), folds, straight_leg(graph)), State::kCertified);
  }
}

TEST(Certificate, HoldsForASinglePanel) {
  const DualGraph graph = build_dual_graph(open_strip(3));
  EXPECT_EQ(judge(make_foldable(graph), {}, straight_leg(graph)), State::kCertified);
}

TEST(Certificate, HoldsForALegInWhichNothingTurns) {
  const Mesh mesh = star();
  const DualGraph graph = build_dual_graph(mesh);
  const FoldTree folds = searched_net(mesh, graph, 1, 0);
  const Foldable foldable = make_foldable(graph);
  for (const double share : {0.0, 1.0}) {
    const Leg still = {fold_angles(graph, share), fold_angles(graph, share)};
    EXPECT_EQ(judge(foldable, folds, still), State::kCertified);
  }
}

TEST(Certificate, IsRefusedWhereFacesOverlapFromTheStart) {
  const Mesh mesh = star();
  const DualGraph graph = build_dual_graph(mesh);
  Random random(1);
  FoldTree folds;
  do folds = random_tree(graph, random);
  while (overlaps_of(graph, folds).empty());
  const Foldable foldable = make_foldable(graph);
  const Leg still = {fold_angles(graph, 0), fold_angles(graph, 0)};
  EXPECT_EQ(judge(foldable, folds, still), State::kRefuted);
  EXPECT_EQ(judge(foldable, folds, straight_leg(graph)), State::kRefuted);
}

TEST(Certificate, DoesNotDependOnTheSlicing) {
  const Mesh mesh = bumpy_sphere(100);
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  int refuted = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const FoldTree folds = searched_net(mesh, graph, seed, seed % 2 == 0 ? kClearance : 0);
    const auto run = [&](std::int64_t slice) {
      Certificate certificate(foldable, folds, straight_leg(graph));
      double progress = 0;
      while (certificate.step(slice) == State::kRunning) {
        EXPECT_GE(certificate.progress(), progress);
        EXPECT_LE(certificate.progress(), 1);
        progress = certificate.progress();
      }
      EXPECT_EQ(certificate.step(slice), certificate.state());
      return std::pair(certificate.state(), certificate.counterexamples());
    };
    const auto at_once = run(kToTheEnd);
    refuted += at_once.first == State::kRefuted ? 1 : 0;
    for (const std::int64_t slice : {1, 37, 5000}) EXPECT_EQ(run(slice), at_once);
  }
  EXPECT_GT(refuted, 0);
}

TEST(Certificate, HasCounterexamplesApartFromEachOther) {
  const Mesh mesh = star();
  const DualGraph graph = build_dual_graph(mesh);
  const Foldable foldable = make_foldable(graph);
  Random random(4);
  for (int i = 0; i < 10; ++i) {
    Certificate certificate(foldable, random_tree(graph, random), straight_leg(graph));
    ASSERT_EQ(certificate.step(kToTheEnd), State::kRefuted);
    const auto& times = certificate.counterexamples();
    ASSERT_FALSE(times.empty());
    EXPECT_LE(times.size(), 4u);
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_GE(times[k], 0);
      EXPECT_LE(times[k], 1);
      if (k > 0) {
        EXPECT_LT(times[k], times[k - 1]) << "late ones come first";
      }
    }
  }
}

TEST(StraightLeg, GoesFromFlatToTheModel) {
  const DualGraph graph = build_dual_graph(cube());
  const Leg leg = straight_leg(graph);
  EXPECT_EQ(leg.from, std::vector<double>(12, 0));
  for (int h = 0; h < 12; ++h) EXPECT_EQ(leg.to[h], graph.hinges[h].angle);
}

}  // namespace
}  // namespace foldwright::testing
