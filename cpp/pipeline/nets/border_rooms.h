#pragma once

#include <array>
#include <map>

#include "paper/craft_cost.h"
#include "pipeline/state.h"

namespace foldwright {

/// The edges that two nets share, and the room for a flap that each of them has there.
///
/// Nets are improved side by side, so that for each edge one of them answers: the one with more
/// room, of equals the lower. It counts its own room only; the other one may rely on it.
class BorderRooms {
 public:
  explicit BorderRooms(const JobState& state);

  /// What net `net` is told of the other sides of its border.
  std::vector<BorderRoom> seen_by(int net) const;
  /// The room that net `net` has there now.
  void note(int net, const std::vector<BorderRoom>& rooms);

 private:
  struct Border {
    std::array<int, 2> nets;
    std::array<double, 2> heights = {0, 0};
  };
  std::map<int, Border> borders_;           ///< by mesh edge
  std::vector<std::vector<int>> edges_of_;  ///< per net
};

}  // namespace foldwright
