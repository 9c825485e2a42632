#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "paper/necks.h"
#include "paper/outline.h"
#include "pipeline/nets/unchecked_notices.h"
#include "pipeline/saved_net.h"
#include "pipeline/sheets/model_size.h"
#include "pipeline/sheets/paper_plan.h"
#include "pipeline/sheets/small_bodies.h"
#include "pipeline/stage.h"

namespace foldwright {
namespace {

/// Per face of the file as read the part of the first triangle that came from it.
std::vector<int> source_segmentation(const JobState& state) {
  const SourceModel& model = *state.model.source;
  std::vector<int> segmentation(model.file_face_count, -1);
  for (std::size_t face = 0; face < model.source_faces.size(); ++face) {
    if (model.source_faces[face] == -1) continue;  // fills a hole
    int& part = segmentation[model.source_faces[face]];
    // Triangles of one polygon may lie in two parts when it is not flat.
    if (part != -1) continue;
    const int standin =
        model.face_standins.empty() ? static_cast<int>(face) : model.face_standins[face];
    part = state.parts.labels[standin];
  }
  return segmentation;
}

/// The motion of a net's folds as one of its edges.
PieceMotion make_motion(const DualGraph& graph, const FoundNet& found, const Net& net) {
  PieceMotion motion;
  motion.kind = found.motion.kind;
  motion.times = found.motion.times;
  const int root = graph.panel_faces(tree_centre(graph, found.folds))[0];
  motion.root = static_cast<int>(std::ranges::lower_bound(net.faces, root) - net.faces.begin());
  std::map<int, std::size_t> fold_of_edge;
  for (std::size_t fold = 0; fold < found.folds.size(); ++fold) {
    for (const int e : graph.hinges[found.folds[fold]].edges) fold_of_edge[e] = fold;
  }
  for (const std::vector<double>& shares : found.motion.shares) {
    std::vector<double>& angles = motion.angles.emplace_back();
    for (const NetEdge& edge : net.edges) {
      // Edges within a panel stay as flat as they are.
      const auto fold = fold_of_edge.find(edge.mesh_edge);
      const bool folds = edge.assignment != Assignment::kCut && fold != fold_of_edge.end();
      angles.push_back(folds ? shares[fold->second] * edge.angle : 0);
    }
  }
  return motion;
}

Mesh scaled(Mesh mesh, double factor) {
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

/// Lengths in millimetres of the folds that are too short for what hangs at them.
std::vector<double> neck_lengths(const DualGraph& graph, const FoldTree& folds, double scale) {
  std::vector<char> is_fold(graph.hinge_count(), 0);
  for (const int h : folds) is_fold[h] = 1;
  std::vector<double> lengths;
  for (const int h : find_necks(graph, is_fold, scale)) {
    lengths.push_back(graph.hinges[h].length * scale);
  }
  std::ranges::sort(lengths);
  return lengths;
}

/// `mesh`: the model in millimetres, `scale` times the state's.
Piece make_piece(const JobState& state, const Mesh& mesh, double scale, const FoundNet& found,
                 Net net) {
  const DualGraph graph =
      restrict_to(state.parts.components[found.region.component].graph, found.region.panels);
  Piece piece{.part = found.region.part, .cause = found.region.cause, .net = std::move(net)};
  piece.motion = make_motion(graph, found, piece.net);
  piece.check = check_net(mesh, piece.net);
  piece.outlines = boundary_walks(piece.net);
  piece.necks = neck_lengths(graph, found.folds, scale);
  return piece;
}

const char* unit_name(Unit unit) {
  switch (unit) {
    case Unit::kCentimetre:
      return "cm";
    case Unit::kMetre:
      return "m";
    case Unit::kInch:
      return "in";
    default:
      return "mm";
  }
}

/// Where pieces hang together by little. Whoever knows may strengthen them with tape.
void add_neck_notice(JobState& state) {
  std::vector<std::string> names;
  for (const Piece& piece : state.result->pieces) {
    if (!piece.necks.empty()) names.push_back(piece.name);
  }
  if (!names.empty()) state.notices.push_back({"weak-necks", {{"pieces", names}}});
}

/// What a person should know about the size: a unit that was guessed, parts that were cut again.
void add_size_notices(JobState& state) {
  const SizeOptions& size = state.options.paper.size;
  const ModelUnit unit = model_unit(state.model.surface->mesh, size.unit);
  if (size.by == Sizing::kScale && unit.guessed) {
    state.notices.push_back({"unit-guessed", {{"unit", unit_name(unit.unit)}}});
  }
  std::map<int, int> recut;  // pieces of each part that was too large
  for (const Piece& piece : state.result->pieces) {
    if (piece.cause == Cause::kSheet) ++recut[piece.part];
  }
  for (const auto& [part, count] : recut) {
    state.notices.push_back({"sheet-split", {{"part", part + 1}, {"pieces", count}}});
  }
}

/// A size, in whole millimetres, at which the model would need fewer sheets.
void add_smaller_notice(JobState& state, const SheetLayout& sheets,
                        const std::optional<PaperPlan::Smaller>& smaller) {
  if (!smaller) return;
  const Vec3 extent = extents(state.model.surface->mesh);
  const bool by_width = state.options.paper.size.by == Sizing::kWidth;
  const bool by_depth = state.options.paper.size.by == Sizing::kDepth;
  const double along = by_width ? extent.x() : by_depth ? extent.z() : extent.y();
  const double size = std::floor(along * smaller->scale);
  // A flat model has no height, and of a tiny one a millimetre is much.
  if (size < 20) return;
  state.notices.push_back({"smaller-saves-sheets",
                           {{"what", by_width   ? "width"
                                     : by_depth ? "depth"
                                                : "height"},
                            {"size_mm", size},
                            {"instead_mm", along * sheets.scale},
                            {"sheets", smaller->sheets},
                            {"of", sheets.sheet_count}}});
}

/// What is glued although no face continues it.
void add_joint_notice(JobState& state) {
  const std::size_t count = state.model.surface->mesh.joints.size();
  if (count == 0) return;
  const bool has_ids = state.options.paper.ids != IdPlace::kNone;
  state.notices.push_back({"joints", {{"what", has_ids ? "numbered" : "bare"}, {"count", count}}});
}

void add_pin_notice(JobState& state, int lost) {
  if (lost > 0) state.notices.push_back({"pin-lost", {{"count", lost}}});
}

/// Makes pieces of the nets, checks them by other means, and lays them on sheets.
class PaperStage : public Stage {
 public:
  StageId id() const override { return StageId::kPaper; }

  void begin(JobState& state, TaskQueue&, Events&) override {
    planner_.emplace(state, state.in_a_hurry);
  }

  bool go_on(JobState& state, Events&) override {
    if (!plan_) {
      if (!planner_->step()) return false;
      plan_ = planner_->take();
      mesh_ = scaled(state.model.surface->mesh, plan_->draft.sheets.scale);
      return false;
    }
    if (pieces_.size() < plan_->draft.nets.size()) {
      add_piece(state);
      return false;
    }
    return true;
  }

  void end(JobState& state, Events& events) override {
    JobResult& result = state.result.emplace();
    result.labels = state.parts.labels;
    result.file = state.model.source->file;
    result.simplified_deviation = state.model.source->simplified_deviation;
    result.looks = state.model.source->looks;
    result.segmentation = source_segmentation(state);
    result.pieces = std::move(pieces_);
    PaperDraft& draft = plan_->draft;
    result.sheets = std::move(draft.sheets);
    result.flap_counts = draft.flaps.counts;
    result.missed_flaps = std::move(draft.flaps.missed);
    result.strips = std::move(plan_->strips);
    result.taped = plan_->taped;
    result.seams = std::move(plan_->labels.seams);
    result.printed_ids = plan_->labels.printed;
    result.skipped_ids = std::move(plan_->labels.skipped);
    for (std::size_t i = 0; i < draft.nets.size(); ++i) {
      FoundNet& net = draft.nets[i];
      const Placement& place = result.sheets.placements[i];
      RigidMotion2 motion = result.sheets.turns[i];
      motion.t += Vec2(place.x, place.y);
      net.place = {place.sheet, motion};
      result.nets.push_back(save_net(state.parts.components[net.region.component], net));
    }
    // Whoever wants them printed after all need not search them again.
    for (const FoundNet& net : without_small_bodies(state, result.sheets.scale).left_out) {
      result.nets.push_back(save_net(state.parts.components[net.region.component], net));
    }
    add_size_notices(state);
    add_smaller_notice(state, result.sheets, plan_->smaller);
    add_small_bodies_notice(state, result.sheets.scale);
    add_joint_notice(state);
    add_pin_notice(state, draft.lost_pins);
    add_neck_notice(state);
    add_unchecked_notices(state, draft.nets);
    result.mesh = state.model.surface->mesh;
    result.repairs = state.model.source->repairs;
    result.parts = state.parts.count;
    result.names = state.parts.names;
    result.moves = state.nets.moves;
    result.generations = state.nets.generations;
    result.notices = std::move(state.notices);
    for (const Notice& notice : result.notices) events.push_back(notice);
    result.hash = hash_of(canonical_dump(result));
  }

  double progress(const JobState&, const Running&) const override {
    if (!plan_) return planner_ ? 0.8 * planner_->progress() : 0;
    const auto count = static_cast<double>(plan_->draft.nets.size());
    return 0.8 + 0.2 * static_cast<double>(pieces_.size()) / count;
  }

 private:
  void add_piece(const JobState& state) {
    const std::size_t i = pieces_.size();
    PaperDraft& draft = plan_->draft;
    Piece& piece = pieces_.emplace_back(
        make_piece(state, mesh_, draft.sheets.scale, draft.nets[i], std::move(draft.flat[i])));
    piece.name = std::move(draft.names[i]);
    piece.angle = std::atan2(draft.sheets.turns[i].s, draft.sheets.turns[i].c);
    piece.flaps = std::move(draft.flaps.flaps[i]);
    piece.labels = std::move(plan_->labels.labels[i]);
    piece.tape_marks = std::move(plan_->labels.tape_marks[i]);
    piece.joint_lines = std::move(plan_->labels.joint_lines[i]);
  }

  std::optional<PaperPlanner> planner_;
  std::optional<PaperPlan> plan_;
  Mesh mesh_;  ///< the model in millimetres
  std::vector<Piece> pieces_;
};

}  // namespace

std::unique_ptr<Stage> make_paper_stage() { return std::make_unique<PaperStage>(); }

}  // namespace foldwright
