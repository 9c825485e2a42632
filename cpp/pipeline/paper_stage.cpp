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

Piece make_piece(const JobState& state, const FoundNet& found) {
  const DualGraph graph =
      restrict_to(state.components[found.region.component].graph, found.region.panels);
  Piece piece{found.region.part,
              found.region.cause,
              make_net(state.surface->mesh, graph, found.folds),
              {},
              {}};
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
