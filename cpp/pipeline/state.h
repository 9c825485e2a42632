#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/events.h"
#include "pipeline/options.h"
#include "pipeline/task.h"

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

/// An edge-connected component of the model.
struct Component {
  std::vector<int> panels;  ///< of the model's graph, ascending
  DualGraph graph;          ///< of those panels
  bool convex = false;      ///< no hinge is a valley
  int parts = 0;            ///< asked of it; 0 estimates
  std::optional<Learned> learned;
  Labels labels;  ///< per panel of `graph`: its part within the component
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
};

/// A region and the fold tree that makes it a net.
struct FoundNet {
  Region region;
  FoldTree folds;  ///< of the graph restricted to the region
  FoldMotion motion;
};

/// What the stages of a job hand on to each other.
struct JobState {
  std::vector<std::byte> file;
  std::string file_name;
  JobOptions options;

  RepairedModel model;  ///< the mesh moves on into `surface`
  std::shared_ptr<const Surface> surface;
  /// Per face of the repaired model the face of `surface` that stands for it; empty when
  /// simplifying left it alone.
  std::vector<int> face_standins;
  std::vector<int> source_faces;  ///< per face of the repaired model
  std::vector<Component> components;
  int parts = 0;
  std::vector<FoundNet> nets;
  bool in_a_hurry = false;  ///< the job was cancelled, and what there is has to be shown soon
  std::int64_t moves = 0;
  int generations = 0;
  std::vector<Notice> notices;
  JobResult result;
};

}  // namespace foldwright
