// Bodies and parts that are the same but for where they are get the same nets.

#include <gtest/gtest.h>

#include <map>

#include "craft_shapes.h"
#include "data_files.h"
#include "job_runs.h"
#include "shared_models.h"
#include "solids.h"

namespace foldwright::testing {
namespace {

/// What a net looks like, however it is turned and mirrored: lengths of its cuts and folds.
std::map<std::pair<char, long>, int> look_of(const Piece& piece) {
  std::map<std::pair<char, long>, int> look;
  for (const NetEdge& edge : piece.net.edges) {
    const double length =
        (piece.net.vertices[edge.vertices[1]] - piece.net.vertices[edge.vertices[0]]).norm();
    ++look[{static_cast<char>(edge.assignment), std::lround(100 * length)}];
  }
  return look;
}

Solid moved(Solid solid, const Vec3& by) {
  for (Vec3& p : solid.positions) p += by;
  return solid;
}

/// A crate with a lid of planks: a box of unequal sides on which a smaller one stands, in one body.
Solid crate() {
  return prism_over("crate", {{0, 0}, {30, 0}, {30, 8}, {20, 8}, {20, 13}, {7, 13}, {7, 8}, {0, 8}},
                    22);
}

TEST(EqualBodies, AreSearchedOnceAndGetEqualNets) {
  std::vector<Solid> crates;
  for (int i = 0; i < 20; ++i)
    crates.push_back(moved(crate(), {40.0 * (i % 5), 30.0 * (i / 5), 0}));
  const JobOptions options{.parts = {.count = 20},
                           .paper = {.size = {.by = Sizing::kScale, .value = 1}}};
  const Outcome one = run_file(obj_of(crate()), "one.obj",
                               {.parts = {.count = 1}, .paper = {.size = options.paper.size}});
  const Outcome all = run_file(obj_of(together("crates", crates)), "crates.obj", options);
  expect_sound(all);
  ASSERT_EQ(all.result->pieces.size(), 20u);
  EXPECT_EQ(all.result->parts, 20);
  for (const Piece& piece : all.result->pieces) {
    EXPECT_EQ(look_of(piece), look_of(all.result->pieces[0]));
    EXPECT_EQ(piece.motion.kind, Folding::kLine);
  }
  EXPECT_LT(all.result->moves, 3 * one.result->moves + 1000);
}

TEST(EqualBodies, OfSeveralPartsHaveEqualParts) {
  const Solid shape = craft_shapes()[7].solid;  // torus
  const Solid two = together("two", {shape, moved(shape, {400, 0, 0})});
  const Outcome outcome = run_file(obj_of(two), "two.obj", {.parts = {.count = 8, .runs = 50}});
  expect_sound(outcome);
  EXPECT_EQ(outcome.result->parts, 8);
  std::map<std::map<std::pair<char, long>, int>, int> looks;
  for (const Piece& piece : outcome.result->pieces) ++looks[look_of(piece)];
  for (const auto& [look, count] : looks) EXPECT_EQ(count % 2, 0);
}

TEST(EqualBodies, AreHandedOverWhereTheSearchIsCancelled) {
  std::vector<Solid> crates;
  for (int i = 0; i < 4; ++i) crates.push_back(moved(crate(), {40.0 * i, 0, 0}));
  Job job({{"crates.obj", to_bytes(obj_of(together("crates", crates)))}}, {.parts = {.count = 4}});
  Outcome outcome;
  while (!job.finished()) {
    append(outcome, job.step(100));
    if (!outcome.all<NetEvent>().empty()) append(outcome, job.cancel());
  }
  const auto cancelled = outcome.all<CancelledEvent>();
  ASSERT_EQ(cancelled.size(), 1u);
  ASSERT_TRUE(cancelled[0].best);
  EXPECT_EQ(cancelled[0].best->pieces.size(), 4u);
}

/// Lengths of all edges, cut or not: equal for pieces of congruent faces.
std::map<long, int> faces_of(const Piece& piece) {
  std::map<long, int> lengths;
  for (const auto& [edge, count] : look_of(piece)) {
    lengths[edge.second] += edge.first == static_cast<char>(Assignment::kCut) ? count : 2 * count;
  }
  return lengths;
}

TEST(EqualParts, OfAMirroredBodyGetMirroredNets) {
  const auto files = corpus_files();
  const auto rabbit = std::ranges::find(files, "rabbit.stl",
                                        [](const auto& file) { return file.filename().string(); });
  ASSERT_NE(rabbit, files.end());
  const Outcome outcome = run_file(bytes_of(*rabbit), "rabbit.stl", {.parts = {.count = 8}});
  expect_sound(outcome);
  int twins = 0;
  const std::vector<Piece>& pieces = outcome.result->pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      if (faces_of(pieces[i]) != faces_of(pieces[j])) continue;
      ++twins;
      EXPECT_EQ(look_of(pieces[i]), look_of(pieces[j])) << pieces[i].name << pieces[j].name;
      EXPECT_EQ(pieces[j].motion.kind, Folding::kLine);
    }
  }
  EXPECT_EQ(twins, 2);
}

}  // namespace
}  // namespace foldwright::testing
