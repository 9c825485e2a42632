#pragma once

#include <string>
#include <vector>

#include "parts.h"
#include "unfold/heuristics.h"

namespace foldwright::testing {

/// The convex hulls on which heuristics are judged: `count` of 20 to 120 points on a sphere.
std::vector<Unfoldable> convex_hulls(int count);

/// The smallest shared organic models, each cut into 8 parts; none when the models are missing.
std::vector<Unfoldable> organic_parts();

/// How many of `runs` unfoldings, in as many random directions, are nets.
int count_nets(const Unfoldable& surface, Heuristic heuristic, int runs, std::uint64_t seed);

/// Table of the success of all heuristics, in percent of `runs` unfoldings of every surface.
std::string heuristic_table(int hulls, int runs);

}  // namespace foldwright::testing
