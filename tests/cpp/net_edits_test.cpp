// Edits of single nets: cuts, joins and faces that change their part.

#include "pipeline/edits/net_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/random.h"
#include "job_runs.h"
#include "mesh/input_error.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

const JobOptions kOptions = {.parts = {.count = 4, .runs = 40},
                             .nets = {.compaction = false},
                             .paper = {.size = {Sizing::kHeight, 40}}};

JobStart start_of(const JobResult& result, std::vector<NetEdit> edits) {
  const SheetLayout& sheets = result.sheets;
  return {.labels = result.labels,
          .nets = result.nets,
          .net_edits = std::move(edits),
          .paper = EarlierPaper{sheets.scale, sheets.sheet_count, sheets.sheet_width}};
}

Outcome run_from(const Mesh& mesh, JobStart start, const JobOptions& options = kOptions) {
  return run_job(Job({{"model.obj", to_bytes(obj_of(mesh))}}, options, std::move(start)), kSlice);
}

EdgeName name_of(const Mesh& mesh, int edge) {
  const auto& [a, b] = mesh.edges[edge].vertices;
  return {a, b};
}

std::set<int> folds_of(const JobResult& result) {
  std::set<int> folds;
  for (const Piece& piece : result.pieces) {
    for (const NetEdge& edge : piece.net.edges) {
      if (edge.assignment != Assignment::kCut) folds.insert(edge.mesh_edge);
    }
  }
  return folds;
}

/// A fold in the middle of the largest net.
EdgeName some_fold(const JobResult& result) {
  const auto largest = std::ranges::max_element(
      result.nets, {}, [](const SavedNet& net) { return net.folds.size(); });
  return name_of(result.mesh, largest->folds[largest->folds.size() / 2]);
}

/// Where a face lies on paper.
std::array<Vec2, 3> place_of(const JobResult& result, int face) {
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    const Net& net = result.pieces[i].net;
    const auto found = std::ranges::lower_bound(net.faces, face);
    if (found == net.faces.end() || *found != face) continue;
    std::array<Vec2, 3> corners;
    const Placement& place = result.sheets.placements[i];
    for (int k = 0; k < 3; ++k) {
      const int v = net.corners[found - net.faces.begin()][k];
      corners[k] = net.vertices[v] + Vec2(place.x, place.y + 1000.0 * place.sheet);
    }
    return corners;
  }
  ADD_FAILURE() << "face " << face << " is in no piece";
  return {};
}

std::string code_of(const Outcome& outcome) {
  const auto errors = outcome.all<ErrorEvent>();
  return errors.size() == 1 ? errors[0].message.code : "";
}

/// A result to edit, over a model with room on its sheet.
struct Edited {
  Mesh mesh = torus(12, 9);
  Outcome outcome = run(mesh, kOptions);
  const JobResult& result() const { return *outcome.result; }
  Outcome apply(NetEdit edit) const {
    return run_from(mesh, start_of(result(), {std::move(edit)}));
  }
};

TEST(NetEdits, CutANetInTwoThatKeepTheirMotion) {
  const Edited edited;
  const JobResult& before = edited.result();
  const EdgeName fold = some_fold(before);
  const Outcome after = edited.apply(CutEdit{fold});
  expect_sound(after);
  EXPECT_EQ(after.result->pieces.size(), before.pieces.size() + 1);
  EXPECT_EQ(after.result->labels, before.labels);
  EXPECT_EQ(folds_of(*after.result).size() + 1, folds_of(before).size());
  EXPECT_EQ(std::ranges::count(after.result->pieces, Cause::kEdit, &Piece::cause), 2);
  for (const Piece& piece : after.result->pieces) EXPECT_NE(piece.motion.kind, Folding::kUnchecked);
}

TEST(NetEdits, LeavePiecesThatTheyDoNotTouchWhereTheyLie) {
  const Edited edited;
  const JobResult& before = edited.result();
  const EdgeName fold = some_fold(before);
  const Outcome after = edited.apply(CutEdit{fold});
  expect_sound(after);
  int moved = 0;
  for (const Piece& piece : before.pieces) {
    const int face = piece.net.faces[0];
    const auto a = place_of(before, face);
    const auto b = place_of(*after.result, face);
    for (int k = 0; k < 3; ++k) moved += (a[k] - b[k]).norm() > 1e-6;
  }
  // All corners of one face at most: one of the halves makes room for flaps of the other.
  EXPECT_LE(moved, 3);
}

TEST(NetEdits, JoinWhatTheyHaveCut) {
  const Edited edited;
  const JobResult& before = edited.result();
  const EdgeName fold = some_fold(before);
  const Outcome cut = edited.apply(CutEdit{fold});
  ASSERT_TRUE(cut.result);
  const Outcome joined = run_from(edited.mesh, start_of(*cut.result, {JoinEdit{fold}}));
  expect_sound(joined);
  EXPECT_EQ(folds_of(*joined.result), folds_of(before));
  EXPECT_EQ(std::ranges::count(joined.result->pieces, Cause::kPart, &Piece::cause),
            static_cast<std::ptrdiff_t>(before.pieces.size()));
  for (const Piece& piece : joined.result->pieces) {
    EXPECT_TRUE(piece.motion.kind == Folding::kLine || piece.motion.kind == Folding::kWaypoints);
  }
}

/// A cut edge whose sides are in one net, or in two.
std::optional<EdgeName> some_cut(const JobResult& result, bool within_one) {
  std::vector<int> net_of(result.labels.size(), -1);
  for (std::size_t i = 0; i < result.nets.size(); ++i) {
    for (const int face : result.nets[i].faces) net_of[face] = static_cast<int>(i);
  }
  const std::set<int> folds = folds_of(result);
  for (std::size_t e = 0; e < result.mesh.edges.size(); ++e) {
    const auto& [a, b] = result.mesh.edges[e].faces;
    if (b == -1 || folds.contains(static_cast<int>(e))) continue;
    if ((net_of[a] == net_of[b]) == within_one) return name_of(result.mesh, static_cast<int>(e));
  }
  return std::nullopt;
}

TEST(NetEdits, OpenTheLoopElsewhereWhenTheyJoinWithinANet) {
  const Mesh mesh = cube();
  const JobOptions options = {.parts = {.count = 1, .runs = 20}, .nets = {.compaction = false}};
  const Outcome before = run(mesh, options);
  ASSERT_TRUE(before.result);
  const EdgeName edge = *some_cut(*before.result, true);
  const Outcome after = run_from(mesh, start_of(*before.result, {JoinEdit{edge}}), options);
  expect_sound(after);
  EXPECT_EQ(after.result->pieces.size(), 1u);
  EXPECT_NE(folds_of(*after.result), folds_of(*before.result));
  // The fold that was opened opens the loop again.
  const auto now = folds_of(*after.result);
  for (const int fold : folds_of(*before.result)) {
    if (now.contains(fold)) continue;
    const JoinEdit back{name_of(mesh, fold), edge};
    const Outcome again = run_from(mesh, start_of(*after.result, {back}), options);
    expect_sound(again);
    EXPECT_EQ(folds_of(*again.result), folds_of(*before.result));
  }
}

TEST(NetEdits, MergePartsWhoseNetsTheyJoin) {
  const Mesh mesh = cube();
  const JobOptions options = {.parts = {.count = 2, .runs = 20}, .nets = {.compaction = false}};
  const Outcome before = run(mesh, options);
  ASSERT_TRUE(before.result);
  ASSERT_EQ(before.result->pieces.size(), 2u);
  const EdgeName edge = *some_cut(*before.result, false);
  JobStart start = start_of(*before.result, {JoinEdit{.edge = edge, .search = true}});
  const Outcome after = run_from(mesh, std::move(start), options);
  expect_sound(after);
  EXPECT_EQ(after.result->parts, 1);
  EXPECT_EQ(after.result->pieces.size(), 1u);
  EXPECT_EQ(after.result->pieces[0].cause, Cause::kPart);
}

EdgeLock lock_of(const EdgeName& edge, bool is_fold) { return {{edge.from, edge.to}, is_fold}; }

bool folds_at(const JobResult& result, const EdgeName& edge) {
  for (const int e : folds_of(result)) {
    if (is_same_edge(name_of(result.mesh, e), edge)) return true;
  }
  return false;
}

JobOptions with_locks(std::vector<EdgeLock> locks) {
  JobOptions options = kOptions;
  options.parts.locks = std::move(locks);
  return options;
}

TEST(NetEdits, LockAnEdgeThatIsThenAlwaysCut) {
  const Edited edited;
  const SavedNet& net = edited.result().nets[0];
  EdgeName edge{};
  JobOptions options;
  Outcome locked;
  for (const int fold : net.folds) {
    const auto& [v, w] = edited.result().mesh.edges[fold].vertices;
    edge = {v, w};
    options = with_locks({lock_of(edge, false)});
    locked =
        run_from(edited.mesh, start_of(edited.result(), {LockEdit{edge, LockKind::kCut}}), options);
    // Where a part hangs together by a fold alone, that cannot be done.
    if (code_of(locked) != "would-fall-apart") break;
  }
  expect_sound(locked);
  EXPECT_FALSE(folds_at(*locked.result, edge));
  // Whatever is done to the parts afterwards.
  for (int into : {1, 2}) {
    JobStart again = start_of(*locked.result, {});
    for (int part = 0; part < locked.result->parts; ++part) {
      again.part_edits.push_back({{part}, into});
    }
    const Outcome after = run_from(edited.mesh, std::move(again), options);
    expect_sound(after);
    EXPECT_FALSE(folds_at(*after.result, edge)) << "into " << into;
  }
  JobStart join = start_of(*locked.result, {JoinEdit{edge}});
  EXPECT_EQ(code_of(run_from(edited.mesh, std::move(join), options)), "locked");
}

/// Whether a result folds at every edge that is locked as a fold.
bool keeps_locks(const JobResult& result, const std::vector<EdgeLock>& locks) {
  return std::ranges::all_of(locks, [&](const EdgeLock& lock) {
    return folds_at(result, {lock.vertices[0], lock.vertices[1]});
  });
}

/// Locks of the first folds of the largest net, but for so many.
std::vector<EdgeLock> locks_of_largest(const JobResult& result, std::size_t free) {
  const SavedNet& largest = *std::ranges::max_element(
      result.nets, {}, [](const SavedNet& net) { return net.folds.size(); });
  std::vector<EdgeLock> locks;
  for (std::size_t i = 0; i + free < largest.folds.size(); ++i) {
    locks.push_back(lock_of(name_of(result.mesh, largest.folds[i]), true));
  }
  return locks;
}

TEST(NetEdits, LockEdgesThatAreThenAlwaysFolds) {
  const Edited edited;
  const std::vector<EdgeLock> locks = locks_of_largest(edited.result(), 2);
  ASSERT_GT(locks.size(), 3u);
  JobOptions options = with_locks(locks);
  options.nets.compaction = true;
  for (int into : {1, 2}) {
    JobStart start = start_of(edited.result(), {});
    for (int part = 0; part < edited.result().parts; ++part) {
      start.part_edits.push_back({{part}, into});
    }
    const Outcome after = run_from(edited.mesh, std::move(start), options);
    expect_sound(after);
    EXPECT_TRUE(keeps_locks(*after.result, locks)) << "into " << into;
  }
  const EdgeName first = {locks[0].vertices[0], locks[0].vertices[1]};
  JobStart cut = start_of(edited.result(), {CutEdit{first}});
  EXPECT_EQ(code_of(run_from(edited.mesh, std::move(cut), options)), "locked");
}

TEST(NetEdits, LockFoldsThatStayWherePiecesAreCutForTheSheet) {
  const Edited edited;
  const JobResult& before = edited.result();
  const std::size_t folds = before.nets[0].folds.size();
  ASSERT_GT(folds, 8u);
  // A few of them, which still fit the sheet when the model is four times as large.
  std::vector<EdgeLock> locks;
  for (std::size_t i = 0; i < 4; ++i) {
    locks.push_back(lock_of(name_of(edited.mesh, before.nets[0].folds[i * folds / 4]), true));
  }
  JobOptions options = with_locks(locks);
  options.paper.size.value = 160;
  JobStart start = start_of(before, {});
  start.paper.reset();
  const Outcome after = run_from(edited.mesh, std::move(start), options);
  expect_sound(after);
  EXPECT_TRUE(keeps_locks(*after.result, locks));
  EXPECT_GT(after.result->pieces.size(), before.pieces.size());
}

TEST(NetEdits, JoinACutThatIsLockedAsAFold) {
  const Edited edited;
  const EdgeName fold = some_fold(edited.result());
  const Outcome cut = edited.apply(CutEdit{fold});
  ASSERT_TRUE(cut.result);
  JobStart start = start_of(*cut.result, {LockEdit{fold, LockKind::kFold}});
  const Outcome locked = run_from(edited.mesh, std::move(start), with_locks({lock_of(fold, true)}));
  expect_sound(locked);
  EXPECT_EQ(folds_of(*locked.result), folds_of(edited.result()));
}

TEST(NetEdits, MoveFacesToAnotherPart) {
  const Edited edited;
  const JobResult& before = edited.result();
  for (const Mesh::Edge& edge : before.mesh.edges) {
    const auto& [a, b] = edge.faces;
    if (b == -1 || before.labels[a] == before.labels[b]) continue;
    const Outcome after = edited.apply(AssignEdit{{a}, before.labels[b]});
    if (code_of(after) == "would-fall-apart") continue;
    expect_sound(after);
    EXPECT_EQ(after.result->labels[a], before.labels[b]);
    EXPECT_EQ(after.result->parts, before.parts);
    return;
  }
  FAIL() << "no face can change its part";
}

TEST(NetEdits, RefuseWhatCannotBeDone) {
  const Edited edited;
  const JobResult& before = edited.result();
  const EdgeName fold = some_fold(before);
  EXPECT_EQ(code_of(edited.apply(CutEdit{{0, 0}})), "no-edge");
  EXPECT_EQ(code_of(edited.apply(JoinEdit{fold})), "already-joined");
  EXPECT_EQ(code_of(edited.apply(CutEdit{*some_cut(before, false)})), "already-cut");
  EXPECT_EQ(code_of(edited.apply(AssignEdit{{}, 0})), "no-face");
  EXPECT_EQ(code_of(edited.apply(AssignEdit{{1 << 20}, 0})), "no-face");
  EXPECT_EQ(code_of(edited.apply(AssignEdit{{0}, 9})), "no-part");
  if (const auto within = some_cut(before, true)) {
    const JoinEdit elsewhere{*within, *some_cut(before, false)};
    EXPECT_EQ(code_of(edited.apply(elsewhere)), "not-in-loop");
  }
}

TEST(NetEdits, KeepFlatFacesWhole) {
  const Outcome before = run(cube(), {.parts = {.runs = 20}});
  ASSERT_TRUE(before.result);
  const Mesh& mesh = before.result->mesh;
  int inner = 0;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    if (std::abs(fold_angle(mesh, e)) > 1) continue;
    ++inner;
    const CutEdit cut{name_of(mesh, e)};
    EXPECT_EQ(code_of(run_from(cube(), start_of(*before.result, {cut}))), "inside-panel");
  }
  EXPECT_EQ(inner, 6);
}

TEST(NetEdits, NameTheFacesInTheWay) {
  const Mesh mesh = torus(12, 9);
  const JobOptions options = {.parts = {.count = 6, .runs = 40}, .nets = {.compaction = false}};
  const Outcome before = run(mesh, options);
  ASSERT_TRUE(before.result);
  const std::set<int> folds = folds_of(*before.result);
  int refused = 0;
  for (std::size_t e = 0; e < before.result->mesh.edges.size() && refused < 3; ++e) {
    if (folds.contains(static_cast<int>(e))) continue;
    const JoinEdit join{name_of(before.result->mesh, static_cast<int>(e))};
    const Outcome after = run_from(mesh, start_of(*before.result, {join}), options);
    const auto errors = after.all<ErrorEvent>();
    if (errors.empty() || errors[0].message.code != "overlap") continue;
    ++refused;
    EXPECT_GE(errors[0].faces.size(), 2u);
    EXPECT_TRUE(std::ranges::is_sorted(errors[0].faces));
  }
  EXPECT_GT(refused, 0);
}

TEST(NetEdits, KeepEverythingSoundOverRandomEdits) {
  int made = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh mesh = torus(8, 6);
    const JobOptions options = {.parts = {.count = 3, .runs = 20}, .nets = {.compaction = false}};
    Outcome now = run(mesh, options);
    ASSERT_TRUE(now.result);
    for (int i = 0; i < 20; ++i) {
      const int edge = random.below(mesh.edge_count());
      NetEdit edit = CutEdit{name_of(now.result->mesh, edge)};
      if (i % 3 == 1) edit = JoinEdit{name_of(now.result->mesh, edge), {}, random.below(2) == 0};
      if (i % 3 == 2) {
        edit = AssignEdit{{random.below(mesh.face_count())}, random.below(now.result->parts)};
      }
      Outcome next = run_from(mesh, start_of(*now.result, {edit}), options);
      if (!next.result) {
        EXPECT_NE(code_of(next), "");
        EXPECT_NE(code_of(next), "internal");
        EXPECT_NE(code_of(next), "bad-start");
        continue;
      }
      ++made;
      expect_sound(next);
      now = std::move(next);
    }
  }
  EXPECT_GE(made, 10);
}

}  // namespace
}  // namespace foldwright::testing
