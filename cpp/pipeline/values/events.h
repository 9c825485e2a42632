#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/values/result.h"
#include "pipeline/values/task.h"

namespace foldwright {

/// The stages of a job, in their order.
enum class StageId { kRead, kLearn, kCluster, kSearch, kCompact, kPaper };

struct StageEvent {
  StageId stage;
  double progress;  ///< of the whole job, in [0, 1]; never falls
};
/// The repaired model in its own units, once it is read.
struct ModelEvent {
  std::shared_ptr<const Surface> surface;
  std::string file;  ///< that it was read from
};
/// A foldability matrix averaged down to at most 256 rows; bytes, 255 for 1.
struct MatrixPicture {
  int size = 0;
  std::vector<std::uint8_t> values;  ///< row-major
  std::vector<int> blocks;           ///< first row of each part, once rows are sorted by part
};
struct LearnedEvent {
  int runs, of;
  std::optional<MatrixPicture> matrix = {};
};
struct SegmentedEvent {
  std::vector<int> labels;  ///< per face of the mesh
};
/// A generation of the genetic search, or a batch of moves of the tree search.
struct GenerationEvent {
  int part;
  int generation;  ///< of the part, through all its searches
  double best;     ///< fitness of the part's best tree so far; never falls, 0 for a net
  int overlaps;    ///< of that tree
  int hyperbolic;  ///< its N_l; 0 in the tree search, which does not count it
  std::optional<NetPicture> net;
};
struct NetEvent {
  int part, piece;
};
/// What a job that goes on would hand over now: every part has a net, on sheets that could be
/// printed. Nets may still get better to craft, and come to lie elsewhere.
struct DraftEvent {
  std::shared_ptr<const JobResult> result;
};
struct DoneEvent {
  std::shared_ptr<const JobResult> result;
};
/// The job was cancelled; `best` has the nets found so far, and is empty when there are none. Its
/// faces without a net are in no piece.
struct CancelledEvent {
  std::shared_ptr<const JobResult> best;
};
struct ErrorEvent {
  Message message;
  std::vector<int> faces = {};  ///< of the mesh, that it is about
};

/// What a job tells while it runs.
using Event = std::variant<StageEvent, ModelEvent, LearnedEvent, SegmentedEvent, GenerationEvent,
                           NetEvent, Notice, DraftEvent, DoneEvent, CancelledEvent, ErrorEvent>;
using Events = std::vector<Event>;

}  // namespace foldwright
