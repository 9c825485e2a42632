#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// A net whose faces lie as those of another net do, maybe mirrored: legs, wheels, two fins.
struct Twin {
  int of;                 ///< the other net
  Congruence congruence;  ///< from the panels of that one, as a graph of their own
};

/// Per net of a state, the net that it may be made equal to, if any. Nets that others are equal to
/// fold straight if one of their kind does. Nets of an earlier result are left out, and such as
/// fold over waypoints: both stay as they are.
std::vector<std::optional<Twin>> find_twins(const JobState& state);

/// The net of its twin, on its own panels; its motion is kept only if it is certified for both, and
/// else `kUnchecked`. None if faces that touch in the one overlap in the other.
std::optional<FoundNet> copy_of_twin(const JobState& state, const FoundNet& net, const Twin& twin);

/// A net of a region with given folds, named by mesh edges, and the motion of these.
/// \pre they span the region
FoundNet copy_net(const Component& component, Region region, std::span<const int> edges,
                  const FoldMotion& motion);

/// Whether faces of a net overlap.
bool overlaps_itself(const Component& component, const FoundNet& net);

/// Whether what is certified of a net is true of its copy: that is off by far less than the
/// clearance, a hundredth of the same unit.
inline bool is_exact(const Congruence& congruence) { return congruence.error < 1e-6; }

}  // namespace foldwright
