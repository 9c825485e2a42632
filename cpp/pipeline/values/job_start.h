#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "pipeline/values/result.h"

namespace foldwright {

/// Makes some parts that touch into another number of parts: one into several splits it, two into
/// one merges them, one into one searches it again.
struct PartEdit {
  std::vector<int> parts;  ///< of the earlier result, from 0
  int into = 1;
};

/// An edge of the repaired mesh, by its two vertices in either order.
struct EdgeName {
  int from = 0, to = 0;
};

/// Cuts a fold. The net falls in two, and both keep their folds and motion.
struct CutEdit {
  EdgeName edge;
};

/// Joins the two sides of a cut edge. Two nets become one, and their parts, too. In one net the
/// loop is opened at another fold: the one that is named, or else the one that leaves least to
/// glue.
struct JoinEdit {
  EdgeName edge;
  std::optional<EdgeName> open = {};
  bool search = false;  ///< where faces overlap, look for another net of the joined piece
};

/// Moves faces, with the flat panels that they are in, to another part. The parts that they come
/// from and go to are searched again.
struct AssignEdit {
  std::vector<int> faces;
  int part = 0;
};

/// What a person wants an edge to be from now on.
enum class LockKind { kFold, kCut, kFree };

/// Makes an edge what its lock says. A fold is cut, and the piece held together at another edge, or
/// else it falls in two; a cut is joined as by `JoinEdit`. That it stays so is for later jobs,
/// which have the lock in `JobOptions::locks`; in this one it is not looked at there.
struct LockEdit {
  EdgeName edge;
  LockKind as;
};

/// A change of nets that does not go by whole parts.
using NetEdit = std::variant<CutEdit, JoinEdit, AssignEdit, LockEdit>;

/// How large an earlier result was on paper, and on how many sheets of what width.
struct EarlierPaper {
  double scale = 1;  ///< millimetres per model unit
  int sheets = 0;
  double sheet_width = 0;
};

/// An earlier result of the same file, simplified alike, and what to change in it.
struct JobStart {
  std::vector<int> labels;  ///< as in `JobResult`
  std::vector<SavedNet>
      nets;  ///< as in `JobResult`; parts that they do not cover are searched again
  std::vector<NetEdit> net_edits = {};    ///< made first, one after the other
  std::vector<PartEdit> part_edits = {};  ///< a part is named by one of them at most
  /// Set if sheets and size are still those that were asked for then: nets that the edits leave
  /// alone then keep their size and, if that takes no more sheets, their places.
  std::optional<EarlierPaper> paper = {};
};

}  // namespace foldwright
