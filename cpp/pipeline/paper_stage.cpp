#include <algorithm>
#include <map>

#include "paper/outline.h"
#include "paper/sheets.h"
#include "pipeline/stage.h"

namespace foldwright {
namespace {

/// Per face of the file as read the part of the first triangle that came from it.
std::vector<int> source_segmentation(const JobState& state) {
  std::vector<int> segmentation(state.model.source_face_count, -1);
  for (std::size_t face = 0; face < state.source_faces.size(); ++face) {
    int& part = segmentation[state.source_faces[face]];
    // Triangles of one polygon may lie in two parts when it is not flat.
    if (part != -1) continue;
    const int standin =
        state.face_standins.empty() ? static_cast<int>(face) : state.face_standins[face];
    part = state.result.labels[standin];
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

Piece make_piece(const JobState& state, const FoundNet& found) {
  const DualGraph graph =
      restrict_to(state.components[found.region.component].graph, found.region.panels);
  Piece piece{found.region.part,
              found.region.cause,
              make_net(state.surface->mesh, graph, found.folds),
              {},
              {},
              {}};
  piece.motion = make_motion(graph, found, piece.net);
  piece.check = check_net(state.surface->mesh, piece.net);
  piece.outlines = boundary_walks(piece.net);
  return piece;
}

/// Makes pieces of the nets, checks them by other means, and lays them on sheets.
class PaperStage : public Stage {
 public:
  StageId id() const override { return StageId::kPaper; }

  void begin(JobState& state, TaskQueue&, Events& events) override {
    JobResult& result = state.result;
    result.segmentation = source_segmentation(state);
    std::vector<Net> nets;
    for (const FoundNet& found : state.nets) {
      result.pieces.push_back(make_piece(state, found));
      nets.push_back(std::move(result.pieces.back().net));
    }
    result.sheets = lay_on_sheets(nets, state.options.sheet);
    for (std::size_t i = 0; i < nets.size(); ++i) result.pieces[i].net = std::move(nets[i]);
    result.mesh = state.surface->mesh;
    result.repairs = std::move(state.model.repairs);
    result.parts = state.parts;
    result.moves = state.moves;
    result.generations = state.generations;
    result.notices = std::move(state.notices);
    for (const Notice& notice : result.notices) events.push_back(notice);
    result.hash = hash_of(canonical_dump(result));
  }

  double progress(const JobState& state, const Running&) const override {
    return state.result.hash.empty() ? 0 : 1;
  }
};

}  // namespace

std::unique_ptr<Stage> make_paper_stage() { return std::make_unique<PaperStage>(); }

}  // namespace foldwright
