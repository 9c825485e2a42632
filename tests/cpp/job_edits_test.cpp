// Jobs that change an earlier result.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "job_runs.h"
#include "meshes.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

const JobOptions kFive = {.parts = {.count = 5, .runs = 40}, .nets = {.compaction = false}};

JobStart start_of(const JobResult& result, std::vector<PartEdit> edits) {
  return {.labels = result.labels, .nets = result.nets, .part_edits = std::move(edits)};
}

Outcome run_from(const Mesh& mesh, JobStart start, const JobOptions& options = kFive,
                 std::int64_t slice = kSlice) {
  return run_job(Job({{"model.obj", to_bytes(obj_of(mesh))}}, options, std::move(start)), slice);
}

bool same_net(const SavedNet& a, const SavedNet& b) {
  return a.cause == b.cause && a.faces == b.faces && a.folds == b.folds &&
         a.motion.kind == b.motion.kind && a.motion.times == b.motion.times &&
         a.motion.shares == b.motion.shares;
}

/// How many nets of the earlier result are in the later one, bit by bit and under the same number.
int kept_nets(const JobResult& earlier, const JobResult& later) {
  const auto is_kept = [&](const SavedNet& net) {
    return std::ranges::any_of(later.nets, [&](const SavedNet& other) {
      return net.part == other.part && same_net(net, other);
    });
  };
  return static_cast<int>(std::ranges::count_if(earlier.nets, is_kept));
}

std::set<int> faces_of(const JobResult& result, const std::set<int>& parts) {
  std::set<int> faces;
  for (int face = 0; face < static_cast<int>(result.labels.size()); ++face) {
    if (parts.contains(result.labels[face])) faces.insert(face);
  }
  return faces;
}

/// The part of most faces.
int largest_part(const JobResult& result) {
  std::vector<int> faces(result.parts, 0);
  for (const int part : result.labels) ++faces[part];
  return static_cast<int>(std::ranges::max_element(faces) - faces.begin());
}

/// Two parts that share an edge, the lower first.
std::pair<int, int> neighbours(const JobResult& result) {
  for (const Mesh::Edge& edge : result.mesh.edges) {
    if (edge.faces[1] == -1) continue;
    const auto [a, b] = std::minmax(result.labels[edge.faces[0]], result.labels[edge.faces[1]]);
    if (a != b) return {a, b};
  }
  ADD_FAILURE() << "there is one part only";
  return {0, 0};
}

void expect_error(const Outcome& outcome, const std::string& message) {
  const auto errors = outcome.all<ErrorEvent>();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(describe(errors[0].message), message);
}

TEST(JobEdits, ChangeNothingWithoutEdits) {
  for (const Mesh& mesh : {torus(10, 7), star(), dumbbell(), saddle_with_apron(7, 3)}) {
    SCOPED_TRACE(mesh.face_count());
    for (const FoldingMode folding : {FoldingMode::kPrefer, FoldingMode::kOff}) {
      const bool compaction = mesh.face_count() < 100;
      const JobOptions options = {.parts = {.count = 3, .runs = 20},
                                  .nets = {.folding = folding, .compaction = compaction}};
      const Outcome earlier = run(mesh, options);
      expect_sound(earlier);
      const Outcome later = run_from(mesh, start_of(*earlier.result, {}), options);
      expect_sound(later);
      EXPECT_EQ(later.result->hash, earlier.result->hash);
      EXPECT_EQ(later.notices(), earlier.notices());
      EXPECT_EQ(later.result->moves, 0);
      EXPECT_TRUE(later.all<LearnedEvent>().empty());
      EXPECT_EQ(later.all<NetEvent>().size(), later.result->nets.size());
    }
  }
}

TEST(JobEdits, NameAPartAndChangeNothingElse) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  expect_sound(earlier);
  JobOptions options = kFive;
  options.paper.names = {{2, "Left wing"}};
  const Outcome later = run_from(mesh, start_of(*earlier.result, {}), options);
  expect_sound(later);
  EXPECT_EQ(later.result->moves, 0);
  EXPECT_EQ(later.result->names.size(), 1u);
  EXPECT_EQ(kept_nets(*earlier.result, *later.result), 5);
  ASSERT_EQ(later.result->pieces.size(), earlier.result->pieces.size());
  for (std::size_t i = 0; i < later.result->pieces.size(); ++i) {
    const Piece& now = later.result->pieces[i];
    const Piece& before = earlier.result->pieces[i];
    EXPECT_EQ(now.name, now.part == 2 ? "Left wing" : before.name);
    EXPECT_EQ(now.net.vertices, before.net.vertices);
    const Placement& place = later.result->sheets.placements[i];
    const Placement& old = earlier.result->sheets.placements[i];
    EXPECT_EQ(std::tie(place.sheet, place.x, place.y), std::tie(old.sheet, old.x, old.y));
  }
}

TEST(JobEdits, LeaveNamesWithTheirParts) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  const auto [a, b] = neighbours(*earlier.result);
  JobOptions options = kFive;
  for (int part = 0; part < 5; ++part) {
    if (part != b) options.paper.names.push_back({part, "Part no. " + std::to_string(part)});
  }
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{a, b}, 1}}), options);
  expect_sound(later);
  ASSERT_EQ(later.result->names.size(), 4u);
  for (const auto& [part, name] : later.result->names) {
    const auto is_it = [&](const PartName& chosen) { return chosen.name == name; };
    const int before = std::ranges::find_if(options.paper.names, is_it)->part;
    std::set<int> made_of = {before};
    if (before == a) made_of.insert(b);
    EXPECT_EQ(faces_of(*later.result, {part}), faces_of(*earlier.result, made_of)) << name;
  }
}

TEST(JobEdits, KeepPinsOfPartsThatGetOtherNumbers) {
  const Mesh mesh = torus(12, 9);
  JobOptions options = kFive;
  // So that no piece is larger or smaller after the merge.
  options.paper.size = {Sizing::kHeight, 40};
  const Outcome earlier = run(mesh, options);
  expect_sound(earlier);
  const auto [a, b] = neighbours(*earlier.result);
  // The last part fills the gap that the merged one leaves.
  const int last = earlier.result->parts - 1;
  ASSERT_NE(b, last);
  const auto piece = std::ranges::find(earlier.result->pieces, last, &Piece::part);
  // Off the edges, as its flaps may change with its neighbours.
  options.paper.pins = {{last, piece->net.faces[0], {{0, 60, 60}, piece->angle}}};
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{a, b}, 1}}), options);
  expect_sound(later);
  EXPECT_EQ(later.result->labels[piece->net.faces[0]], b);
  for (const Notice& notice : later.result->notices) EXPECT_NE(notice.code, "pin-lost");
}

TEST(JobEdits, SplitAPartAndKeepTheOthersBitByBit) {
  const Mesh mesh = bumpy_sphere(400);
  const Outcome earlier = run(mesh, kFive);
  expect_sound(earlier);
  for (const int into : {1, 2, 4}) {
    SCOPED_TRACE(into);
    const Outcome later = run_from(mesh, start_of(*earlier.result, {{{2}, into}}));
    expect_sound(later);
    EXPECT_EQ(later.result->parts, 4 + into);
    EXPECT_GE(kept_nets(*earlier.result, *later.result), 4);
    std::set<int> made = {2};
    for (int part = 5; part < later.result->parts; ++part) made.insert(part);
    EXPECT_EQ(faces_of(*later.result, made), faces_of(*earlier.result, {2}));
  }
}

TEST(JobEdits, MergeTwoPartsAndKeepTheOthersBitByBit) {
  const Mesh mesh = bumpy_sphere(400);
  const Outcome earlier = run(mesh, kFive);
  const auto [a, b] = neighbours(*earlier.result);
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{b, a}, 1}}));
  expect_sound(later);
  EXPECT_EQ(later.result->parts, 4);
  EXPECT_EQ(faces_of(*later.result, {a}), faces_of(*earlier.result, {a, b}));
  // The last part fills the gap, unless it is the one that went.
  EXPECT_EQ(kept_nets(*earlier.result, *later.result), b == 4 ? 3 : 2);
}

TEST(JobEdits, UndoEachOther) {
  const Mesh mesh = torus(12, 9);
  const Outcome first = run(mesh, kFive);
  const int part = largest_part(*first.result);
  const Outcome split = run_from(mesh, start_of(*first.result, {{{part}, 2}}));
  expect_sound(split);
  const Outcome merged = run_from(mesh, start_of(*split.result, {{{part, 5}, 1}}));
  expect_sound(merged);
  EXPECT_EQ(merged.result->labels, first.result->labels);
  EXPECT_GE(kept_nets(*first.result, *merged.result), 4) << "the merged one may come out the same";
}

TEST(JobEdits, MakeSeveralChangesAtOnce) {
  const Mesh mesh = bumpy_sphere(400);
  const Outcome earlier = run(mesh, kFive);
  const auto [a, b] = neighbours(*earlier.result);
  std::vector<PartEdit> edits = {{{a, b}, 1}};
  for (int part = 0; part < 5; ++part) {
    if (part != a && part != b) edits.push_back({{part}, 2});
  }
  const Outcome later = run_from(mesh, start_of(*earlier.result, edits));
  expect_sound(later);
  EXPECT_EQ(later.result->parts, 7);
}

TEST(JobEdits, SplitAPartIntoItsPanels) {
  const Mesh mesh = random_hull(3, 40);
  const Outcome earlier = run(mesh, kFive);
  const int panels = static_cast<int>(faces_of(*earlier.result, {1}).size());
  ASSERT_GT(panels, 2);
  for (const int into : {panels - 1, panels}) {
    const Outcome later = run_from(mesh, start_of(*earlier.result, {{{1}, into}}));
    expect_sound(later);
    EXPECT_EQ(later.result->parts, 4 + into);
    EXPECT_EQ(kept_nets(*earlier.result, *later.result), 4);
  }
}

TEST(JobEdits, SplitWhatHasNoNetOnceMerged) {
  const Mesh mesh = saddle(8, 7);
  const JobOptions options = {.parts = {.count = 2, .runs = 20}};
  const Outcome earlier = run(mesh, options);
  expect_sound(earlier);
  ASSERT_EQ(earlier.result->parts, 2);
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{0, 1}, 1}}), options);
  expect_sound(later);
  EXPECT_EQ(later.result->parts, 1);
  EXPECT_EQ(later.result->pieces.size(), 2u);
  for (const Piece& piece : later.result->pieces) EXPECT_EQ(piece.cause, Cause::kNoNet);
  EXPECT_EQ(later.notices(), std::multiset<std::string>{"part-split"});
  // A part in two nets is kept as well.
  const Outcome again = run_from(mesh, start_of(*later.result, {}), options);
  expect_sound(again);
  EXPECT_EQ(again.result->hash, later.result->hash);
  EXPECT_EQ(again.notices(), later.notices());
}

TEST(JobEdits, GiveTheSameInWhateverSlices) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  const std::vector<PartEdit> edits = {{{largest_part(*earlier.result)}, 3}};
  const Outcome one = run_from(mesh, start_of(*earlier.result, edits));
  expect_sound(one);
  for (const std::int64_t slice : {std::int64_t{1}, std::int64_t{333}}) {
    const Outcome other = run_from(mesh, start_of(*earlier.result, edits), kFive, slice);
    ASSERT_NE(other.result, nullptr);
    EXPECT_EQ(other.result->hash, one.result->hash);
  }
}

TEST(JobEdits, KeepNetsThatSheetsCutAgain) {
  const Mesh mesh = bumpy_sphere(200);
  JobOptions options = {.parts = {.count = 3, .runs = 20}};
  options.paper.size = {Sizing::kHeight, 500};
  const Outcome earlier = run(mesh, options);
  expect_sound(earlier);
  ASSERT_GT(earlier.result->pieces.size(), 3u);
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{0}, 2}}), options);
  expect_sound(later);
  // Of the part that is split a net may come out again by chance, so only the others count.
  JobResult others = *earlier.result;
  std::erase_if(others.nets, [](const SavedNet& net) { return net.part == 0; });
  EXPECT_EQ(kept_nets(others, *later.result), static_cast<int>(others.nets.size()));
}

TEST(JobEdits, SearchPartsWithoutNetsAgain) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  JobStart start = start_of(*earlier.result, {});
  std::erase_if(start.nets, [](const SavedNet& net) { return net.part == 2; });
  const Outcome later = run_from(mesh, start);
  expect_sound(later);
  EXPECT_GE(kept_nets(*earlier.result, *later.result), 4);
}

TEST(JobEdits, LearnLargePartsOnProxies) {
  const Mesh mesh = bumpy_sphere(800);
  const JobOptions options = {.parts = {.count = 2, .runs = 20, .proxy = 100},
                              .nets = {.compaction = false}};
  const Outcome earlier = run(mesh, options);
  const Outcome later = run_from(mesh, start_of(*earlier.result, {{{0}, 3}}), options);
  expect_sound(later);
  EXPECT_EQ(later.result->parts, 4);
  EXPECT_EQ(kept_nets(*earlier.result, *later.result), 1);
}

TEST(JobEdits, KeepWhatIsThereWhenCancelled) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  Job job({{"model.obj", to_bytes(obj_of(mesh))}}, kFive,
          start_of(*earlier.result, {{{largest_part(*earlier.result)}, 2}}));
  Outcome outcome;
  while (!job.finished() && outcome.all<NetEvent>().empty()) append(outcome, job.step(1));
  ASSERT_FALSE(job.finished());
  const Events last = job.cancel();
  const auto best = std::get<CancelledEvent>(last.back()).best;
  ASSERT_NE(best, nullptr);
  EXPECT_GE(kept_nets(*earlier.result, *best), 4);
}

TEST(JobEdits, RefuseWhatCannotBeDone) {
  const Mesh mesh = random_hull(3, 40);
  const Outcome earlier = run(mesh, kFive);
  const auto attempt = [&](std::vector<PartEdit> edits) {
    return run_from(mesh, start_of(*earlier.result, std::move(edits)));
  };
  expect_error(attempt({{{5}, 2}}), "bad-edit what=no-part part=6 parts=5");
  expect_error(attempt({{{-1}, 2}}), "bad-edit what=no-part part=0 parts=5");
  expect_error(attempt({{{}, 2}}), "bad-edit what=no-part-named");
  expect_error(attempt({{{0}, 2}, {{1, 0}, 1}}), "bad-edit what=twice part=1");
  const std::string panels = std::to_string(faces_of(*earlier.result, {0}).size());
  expect_error(attempt({{{0}, 2000000000}}),
               "bad-edit what=into parts=1 into=2000000000 most=" + panels);
  expect_error(attempt({{{0}, 0}}), "bad-edit what=into parts=1 into=0 most=" + panels);
}

TEST(JobEdits, RefuseToMergePartsThatDoNotTouch) {
  const Mesh mesh = accordion({1, 1, 1, 1, 1, 1});
  const JobOptions options = {.parts = {.count = 3, .runs = 20}};
  const Outcome earlier = run(mesh, options);
  expect_sound(earlier);
  std::set<int> ends = {earlier.result->labels.front(), earlier.result->labels.back()};
  ASSERT_EQ(ends.size(), 2u);
  const std::vector<int> parts(ends.begin(), ends.end());
  expect_error(run_from(mesh, start_of(*earlier.result, {{parts, 1}}), options),
               "bad-edit what=apart parts=" + std::to_string(parts[0] + 1) + "," +
                   std::to_string(parts[1] + 1));
}

TEST(JobEdits, RefuseResultsOfOtherModels) {
  const Mesh mesh = torus(12, 9);
  const Outcome earlier = run(mesh, kFive);
  const JobStart good = start_of(*earlier.result, {});
  const auto expect_foreign = [&](const std::string& what, auto&& spoil) {
    SCOPED_TRACE(what);
    JobStart start = good;
    spoil(start);
    expect_error(run_from(mesh, std::move(start)), "bad-start");
  };
  expect_foreign("other size", [](JobStart& s) { s.labels.pop_back(); });
  expect_foreign("negative label", [](JobStart& s) { s.labels[0] = -1; });
  expect_foreign("huge label", [](JobStart& s) { s.labels[0] = 1 << 30; });
  expect_foreign("a part in two pieces", [](JobStart& s) {
    const int far = static_cast<int>(s.labels.size() / 2);
    s.labels[far] = (s.labels[far] + 1) % 5;
    s.labels[far + 30] = (s.labels[far + 30] + 2) % 5;
    s.labels[0] = (s.labels[0] + 1) % 5;
  });
  expect_foreign("no such part", [](JobStart& s) { s.nets[0].part = 5; });
  expect_foreign("a face twice", [](JobStart& s) { s.nets.push_back(s.nets[0]); });
  expect_foreign("a face of another part",
                 [](JobStart& s) { s.nets[0].faces.push_back(s.nets[1].faces[0]); });
  expect_foreign("no spanning tree", [](JobStart& s) { s.nets[0].folds.pop_back(); });
  expect_foreign("a fold twice", [](JobStart& s) { s.nets[0].folds[0] = s.nets[0].folds[1]; });
  expect_foreign("no fold at all", [](JobStart& s) { s.nets[0].folds[0] = -7; });
  expect_foreign("a motion of another net", [](JobStart& s) {
    s.nets[0].motion = straight_motion({0, 1});
  });
  expect_foreign("a motion without keys", [](JobStart& s) {
    s.nets[0].motion = {Folding::kLine, {}, {}};
  });
}

}  // namespace
}  // namespace foldwright::testing
