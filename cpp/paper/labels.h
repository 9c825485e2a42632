#pragma once

#include <memory>
#include <optional>
#include <string>

#include "paper/contacts.h"
#include "paper/flaps.h"
#include "paper/label.h"
#include "paper/seam_ids.h"
#include "paper/text_memory.h"

namespace foldwright {

/// A seam with what is printed at it.
struct NamedSeam {
  std::vector<int> mesh_edges;  ///< ascending
  std::array<int, 2> nets;
  SeamId id;
};

struct LabelPlan {
  std::vector<NamedSeam> seams;            ///< by lowest mesh edge, and after them the joints
  std::vector<std::vector<Label>> labels;  ///< per net; the name comes first if it is there
  int printed = 0;                         ///< cut edges with their id at both sides
  /// Names of the seams that are unreadable at one side at least, see `SeamId::name`; by seam.
  std::vector<std::string> skipped;
  /// Per net: pairs of short strokes over the edges to be joined by tape, at the same place of both
  /// sides.
  std::vector<std::vector<Stroke>> tape_marks;
  /// Per net: lines in its flat panels where something stands.
  std::vector<std::vector<Stroke>> joint_lines;
};

/// Name of a piece from its index: A, B, .. Z, AA, AB, .. as in the columns of a sheet.
std::string piece_letter(int index);

/// What labels are placed on.
struct LabelTask {
  std::span<const Net> nets;                 ///< as they lie on their sheets, in millimetres
  std::span<const std::vector<Flap>> flaps;  ///< per net
  std::span<const std::string> names;        ///< per net
  IdPlace place = IdPlace::kFlap;
  std::span<const int> tape = {};             ///< mesh edges to mark for tape, ascending
  std::span<const Seam> joints = {};          ///< of the nets, see `find_joint_seams`
  TextMemory* memory = nullptr;               ///< of nets that had texts before, if there are some
  SheetObstacles* sheets = nullptr;           ///< gets texts beside nets; for `IdPlace::kOutside`
  std::span<const Standings> standings = {};  ///< per net, or empty
};

/// Names pieces, writes the id of each seam at both of its sides (`seam_ids.h`), and marks edges
/// for tape.
///
/// Texts of ids lie along their edges, as large as those allow, short ones first. What does not fit
/// there in a size that is easy to read stands near by, with a line that leads to the edge; only
/// what has no place either becomes smaller. No text touches a line that is drawn, or another text.
/// Where a joint's host shows no line a line is drawn. Where a body stands flat on another one its
/// rim is drawn, and within that the name of its piece if that has room.
class LabelPlacer {
 public:
  /// What the task refers to must outlive the placer.
  explicit LabelPlacer(const LabelTask& task);
  ~LabelPlacer();

  /// Does some milliseconds of work; true when all is placed.
  bool step();

  /// \pre `step` returned true; leaves the placer empty
  LabelPlan take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// All of it at once.
LabelPlan place_labels(const LabelTask& task);

}  // namespace foldwright
