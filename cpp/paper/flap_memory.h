#pragma once

#include <deque>
#include <string>

#include "paper/flaps.h"

namespace foldwright {

/// Flaps that were placed lately. Names, pins and most options of paper leave them as they are, and
/// placing them takes half of an edit that changes one. Holds 16 MiB at most, but for a larger last
/// one; what was not asked for lately goes first.
class FlapMemory {
 public:
  /// As `place_flaps`, which is called only for what is not held.
  FlapPlan place(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                 std::span<const std::vector<std::vector<Vec2>>> keep_off = {});

 private:
  struct Kept {
    std::string key;
    FlapPlan plan;
  };
  void forget_oldest();

  std::deque<Kept> kept_;  ///< the last one asked for first
};

}  // namespace foldwright
