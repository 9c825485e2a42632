#pragma once

#include <vector>

#include "pipeline/result.h"

namespace foldwright {

/// Makes some parts that touch into another number of parts: one into several splits it, two into
/// one merges them, one into one searches it again.
struct Edit {
  std::vector<int> parts;  ///< of the earlier result, from 0
  int into = 1;
};

/// An earlier result of the same file, simplified alike, and what to change in it.
struct JobStart {
  std::vector<int> labels;  ///< as in `JobResult`
  std::vector<SavedNet>
      nets;                 ///< as in `JobResult`; parts that they do not cover are searched again
  std::vector<Edit> edits;  ///< a part is named by one of them at most
};

}  // namespace foldwright
