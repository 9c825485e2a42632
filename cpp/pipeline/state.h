#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "paper/flap_memory.h"
#include "paper/text_memory.h"
#include "pipeline/model/source_model.h"
#include "pipeline/values/events.h"
#include "pipeline/values/job_start.h"
#include "pipeline/values/options.h"
#include "pipeline/values/task.h"
#include "unfold/congruence.h"

namespace foldwright {

/// Keys of surfaces: the model, and behind it the proxy of each component.
inline constexpr int kModelSurface = 0;
inline constexpr int kFirstProxySurface = 1;

/// What was learned about a component, and on which surface.
struct Learned {
  std::shared_ptr<const Surface> surface;  ///< the component itself, or its proxy
  std::vector<int> panels;                 ///< of that surface: the rows of the matrix
  FoldabilityMatrix matrix;
  std::vector<int> rows;  ///< per panel of the component: the row that stands for it
};

/// A part, or a share of one, on its way to a net.
struct Region {
  int component = 0;
  int part = 0;
  Cause cause = Cause::kPart;
  std::vector<int> panels;  ///< of the component's graph, ascending
  /// Its faces meet in the model itself, so that no motion can be certified.
  bool meets_itself = false;
  /// It has more panels than a motion is looked for of.
  bool too_large = false;
  /// It comes from an earlier result: whatever is done to nets leaves this one as it is.
  bool kept = false;
};

/// A region and the fold tree that makes it a net.
struct FoundNet {
  Region region;
  FoldTree folds;  ///< of the graph restricted to the region
  FoldMotion motion;
  std::optional<HeldPlace> place = {};  ///< of an earlier result, where it lay
};

/// A body that is congruent to another one, whose nets become its own.
struct EqualBody {
  int like;               ///< index of the other component, a lower one
  Congruence congruence;  ///< from the panels of that one
};

/// An edge-connected set of panels that is made into parts by itself: a body of the model, or what
/// an edit of an earlier result leaves or makes.
struct Component {
  std::vector<int> panels;  ///< of the model's graph, ascending
  DualGraph graph;          ///< of those panels
  /// Few bends or convex: where nobody says how many parts, a person would try one piece first.
  bool whole_first = false;
  int parts = 0;  ///< asked of it; 0 estimates
  std::optional<Learned> learned;
  Labels labels;  ///< per panel of `graph`: its part within the component
  /// Numbers of its parts among all of the model, ascending; empty until they are known.
  std::vector<int> part_numbers;
  std::optional<EqualBody> equal_to;  ///< learned, clustered and searched is only the other one
  std::vector<FoundNet> kept;         ///< nets of an earlier result, or none
  /// Shares of a part that are searched again beside the nets kept: panels of `graph`, ascending.
  std::vector<std::vector<int>> open;
};

/// A component of some panels of the model, ascending. \pre they are connected
Component make_component(const DualGraph& model, std::vector<int> panels);

/// What jobs in the same worker share. What they remember for those that come after them changes no
/// result, which is only sooner there.
struct JobMemory {
  ModelMemory model;
  FlapMemory flaps;
  TextMemory texts;
  SolidUniter uniter;  ///< what the host lends them to unite bodies; empty where it has none
};

/// The model as it was read and repaired; no stage changes it.
struct ModelState {
  std::shared_ptr<const SourceModel> source;
  std::shared_ptr<const Surface> surface;
};

/// How the model is shared out.
struct PartsState {
  std::vector<Component> components;
  int count = 0;
  std::vector<int> labels;  ///< per face of the surface: the number of its part
  /// As the options have them, by the numbers that parts have after the edits of a start.
  std::vector<PartName> names;
  std::vector<PinnedPiece> pins;
};

/// What was found for the parts.
struct NetsState {
  std::vector<FoundNet> found;
  std::int64_t moves = 0;
  int generations = 0;
};

/// What the stages of a job hand on to each other. What a job is given stays as it is; each of the
/// three values after it is made of those before it.
struct JobState {
  std::shared_ptr<JobMemory> memory = std::make_shared<JobMemory>();  ///< never null
  JobOptions options;
  std::optional<JobStart> start;

  ModelState model;  ///< once it is read
  PartsState parts;
  NetsState nets;
  std::vector<Notice> notices;
  std::optional<JobResult> result;  ///< what the last stage makes of all of that
  bool in_a_hurry = false;  ///< the job was cancelled, and what there is has to be shown soon
};

/// Size and sheets of the earlier result, if nets shall stay where they are; or null.
const EarlierPaper* earlier_paper(const JobState& state);

/// The panels of a region as those of the model's graph.
std::vector<int> model_panels(const JobState& state, const Region& region);

/// Sorts the nets by part, and within a part by lowest panel.
void sort_nets(JobState& state);

/// Makes a part of every net that is only a share of one. Labels of faces are left as they are.
/// \pre nets are sorted, and all panels are in nets
void make_parts_of_pieces(JobState& state);

/// Labels all faces by the parts of their panels. \pre parts have numbers
void label_faces(JobState& state);

}  // namespace foldwright
