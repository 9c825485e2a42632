#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/result.h"

namespace foldwright {

/// The stages of a job, in their order.
enum class StageId { kRead, kLearn, kCluster, kSearch, kPaper };

struct StageEvent {
  StageId stage;
  double progress;  ///< of the whole job, in [0, 1]; never falls
};
struct LearnedEvent {
  int runs, of;
};
struct SegmentedEvent {
  std::vector<int> labels;  ///< per face of the mesh
};
/// A batch of moves of a net search.
struct GenerationEvent {
  int part;
  int generation;  ///< batches so far
  double best;     ///< fitness: minus the overlaps
  int overlaps;
};
struct NetEvent {
  int part, piece;
};
struct DoneEvent {
  std::shared_ptr<const JobResult> result;
};
struct ErrorEvent {
  std::string code, text;
};

/// What a job tells while it runs.
using Event = std::variant<StageEvent, LearnedEvent, SegmentedEvent, GenerationEvent, NetEvent,
                           Notice, DoneEvent, ErrorEvent>;
using Events = std::vector<Event>;

}  // namespace foldwright
