#include "pipeline/nets/search_limits.h"

#include <algorithm>

#include "search/tree_search.h"

namespace foldwright {
namespace {

// Seeds that a region gets before it counts as having no net that folds. A part with one almost
// always shows it at once, and one without is cured at its border. A whole component has no border.
constexpr int kAttemptsOfPart = 3;
constexpr int kAttemptsOfWhole = 12;

// The same where panels have so many faces, as the flat sides of machine parts do, that each
// attempt takes many times as long.
constexpr int kAttemptsOfHeavy = 4;
constexpr double kHeavyFaces = 3;  // per panel

bool is_heavy(const JobState& state, const Region& region) {
  const DualGraph& graph = state.parts.components[region.component].graph;
  double faces = 0;
  for (const int panel : region.panels) {
    faces += static_cast<double>(graph.panel_faces(panel).size());
  }
  return faces > kHeavyFaces * static_cast<double>(region.panels.size());
}

// The same of a large region that has a net: two more attempts at one that folds straight take half
// the time again, and cure one part in 120.
constexpr int kAttemptsOfLarge = 1;

// Swaps without a new best, per panel, before a search gives up, where that is more than the least.
// With the least alone, 20,000 faces in 12 parts take a seventh less time and come to 13.4 pieces
// instead of 12.4, and 70,000 faces a third of the time and come to 75 instead of 30.
constexpr std::int64_t kPatiencePerPanel = 20;
constexpr std::int64_t kLeastPatience = TreeSearchOptions{}.patience;

// An evolution and three restarts, as the paper's authors set it. What evolution does not solve is
// split, as published: border exchange belongs to the tree search.
constexpr int kEvolutions = 4;

// Panels above which no motion is looked for, unless it is required: the search for one takes
// minutes with some thousands, and no person folds such a piece.
constexpr std::size_t kMostToFold = 4000;

}  // namespace

bool is_component(const JobState& state, const Region& region) {
  return region.panels.size() == state.parts.components[region.component].panels.size();
}

bool is_exchangeable(const JobState& state, const Region& region) {
  return region.cause == Cause::kPart && !is_component(state, region) &&
         state.options.nets.solver == Solver::kTree;
}

void note_limits(const JobState& state, Region& region) {
  if (state.options.nets.folding == FoldingMode::kOff) return;
  const DualGraph graph =
      restrict_to(state.parts.components[region.component].graph, region.panels);
  region.meets_itself = meets_itself(make_foldable(graph, state.options.nets.clearance));
  region.too_large =
      state.options.nets.folding == FoldingMode::kPrefer && region.panels.size() > kMostToFold;
}

bool wants_motion(const JobState& state, const Region& region) {
  return state.options.nets.folding != FoldingMode::kOff && !region.meets_itself &&
         !region.too_large;
}

bool is_too_large_to_plan(const JobState& state, const Region& region) {
  return state.options.nets.folding == FoldingMode::kPrefer && region.panels.size() > kLargeRegion;
}

int attempts_for(const JobState& state, const Region& region, bool has_net) {
  if (state.options.nets.solver == Solver::kGenetic) return kEvolutions;
  if (has_net && is_too_large_to_plan(state, region)) return kAttemptsOfLarge;
  if (!is_component(state, region) || has_net) return kAttemptsOfPart;
  return attempts_at_last(state, region);
}

int attempts_at_last(const JobState& state, const Region& region) {
  return is_heavy(state, region) ? kAttemptsOfHeavy : kAttemptsOfWhole;
}

bool deserves_last_attempts(const JobState& state, const Region& region,
                            const Candidate& candidate) {
  return state.options.nets.solver == Solver::kTree && !candidate.is_net() &&
         !is_far_from_net(region, candidate) && region.panels.size() <= kLargeRegion;
}

std::int64_t patience_for(const Region& region) {
  return std::max(kLeastPatience,
                  kPatiencePerPanel * static_cast<std::int64_t>(region.panels.size()));
}

bool is_hopeless(const JobState& state, const Region& region, const Candidate& best) {
  return state.options.nets.solver == Solver::kTree && !is_component(state, region) &&
         is_far_from_net(region, best);
}

}  // namespace foldwright
