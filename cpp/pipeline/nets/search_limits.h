#pragma once

#include "pipeline/nets/part_trees.h"

namespace foldwright {

/// What the search for a net spends on a region, and what it leaves alone.

/// Panels above which a region counts as large: each move takes long, so that attempts go on from
/// what there is.
inline constexpr std::size_t kLargeRegion = 1000;

/// Whether the region is all of its component, and so has no neighbours.
bool is_component(const JobState& state, const Region& region);

/// Whether it is a part that can give its neighbours panels, as the tree search does it.
bool is_exchangeable(const JobState& state, const Region& region);

/// Notes what stands in the way of a motion.
void note_limits(const JobState& state, Region& region);

/// Whether a motion is looked for; `note_limits` must have looked at the region.
bool wants_motion(const JobState& state, const Region& region);

/// Whether a net that does not fold straight is left at that: planning a motion for many panels
/// takes minutes, and no person folds such a piece.
bool is_too_large_to_plan(const JobState& state, const Region& region);

/// Seeds that a region gets before it counts as having no net, or none that folds straight: such a
/// one is planned a motion for sooner than searched anew.
int attempts_for(const JobState& state, const Region& region, bool has_net);

/// Seeds that a whole component gets, and a part before it is cut: in time for a few more attempts
/// than one gets before its borders are moved.
int attempts_at_last(const JobState& state, const Region& region);

/// Whether a part without a net, which no other borders have cured, gets these attempts.
bool deserves_last_attempts(const JobState& state, const Region& region,
                            const Candidate& candidate);

/// Swaps without a new best before a search of the region gives up.
std::int64_t patience_for(const Region& region);

/// Other seeds are no use to a region far from a net, unless there is nothing else.
bool is_hopeless(const JobState& state, const Region& region, const Candidate& best);

}  // namespace foldwright
