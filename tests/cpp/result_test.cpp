#include "pipeline/values/result.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "meshes.h"
#include "trees.h"

namespace foldwright::testing {
namespace {

JobResult small_result() {
  JobResult result;
  result.mesh = cube();
  const DualGraph graph = build_dual_graph(result.mesh);
  result.segmentation = std::vector<int>(12, 0);
  result.labels = std::vector<int>(12, 0);
  result.parts = 1;
  result.pieces.push_back({.net = make_net(result.mesh, graph, all_spanning_trees(graph)[0])});
  result.sheets.scale = 40;
  result.sheets.placements.push_back({0, 10, 20});
  return result;
}

TEST(HashOf, IsFnv1a) {
  EXPECT_EQ(hash_of(""), "cbf29ce484222325");
  EXPECT_EQ(hash_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hash_of("foobar"), "85944171f73967e8");
}

TEST(CanonicalDump, IsEqualForEqualResults) {
  EXPECT_EQ(canonical_dump(small_result()), canonical_dump(small_result()));
}

TEST(CanonicalDump, ShowsEveryChangeOfTheOutcome) {
  const std::function<void(JobResult&)> changes[] = {
      [](JobResult& r) { r.segmentation[3] = 1; },
      [](JobResult& r) { r.pieces[0].part = 1; },
      [](JobResult& r) { r.pieces[0].cause = Cause::kNoNet; },
      [](JobResult& r) { r.pieces[0].net.faces[0] = 5; },
      [](JobResult& r) { r.pieces[0].net.edges[0].mesh_edge += 1; },
      [](JobResult& r) { r.pieces[0].net.edges[0].assignment = Assignment::kValley; },
      [](JobResult& r) { r.pieces[0].net.edges[0].angle += 1e-15; },
      [](JobResult& r) { r.pieces[0].net.vertices[7].y() += 1e-15; },
      [](JobResult& r) { r.pieces[0].flaps.push_back({}); },
      [](JobResult& r) {
        r.pieces[0].labels.push_back({"A", Vec2(1, 2), 0, 3});
      },
      [](JobResult& r) { r.pieces[0].motion.kind = Folding::kLine; },
      [](JobResult& r) { r.pieces[0].motion.root = 1; },
      [](JobResult& r) {
        r.pieces[0].motion.times = {0, 1};
      },
      [](JobResult& r) { r.pieces[0].motion.angles = {{0.5}}; },
      [](JobResult& r) { r.sheets.scale += 1e-12; },
      [](JobResult& r) { r.sheets.placements[0].sheet = 1; },
      [](JobResult& r) { r.sheets.placements[0].x += 1e-12; },
      [](JobResult& r) { r.sheets.placements[0].y += 1e-12; },
  };
  std::set<std::string> hashes = {hash_of(canonical_dump(small_result()))};
  for (const auto& change : changes) {
    JobResult result = small_result();
    change(result);
    EXPECT_TRUE(hashes.insert(hash_of(canonical_dump(result))).second)
        << "change " << hashes.size() << " does not show";
  }
}

TEST(CanonicalDump, LeavesOutHowTheResultWasFound) {
  JobResult result = small_result();
  result.moves = 12345;
  result.generations = 7;
  result.notices.push_back({"part-split", {{"part", 1}}});
  EXPECT_EQ(canonical_dump(result), canonical_dump(small_result()));
}

}  // namespace
}  // namespace foldwright::testing
