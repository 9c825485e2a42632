#pragma once

#include <set>

#include "pipeline/state.h"

namespace foldwright {

/// Bodies of the model, as its faces count them, that are shorter than `JobOptions::min_piece` at
/// a scale in millimetres per model unit, along each axis; never the longest one.
std::set<int> small_bodies(const JobState& state, double scale);

/// The nets of a state, those of small bodies apart: they are not printed.
struct PrintedNets {
  std::vector<FoundNet> printed;
  std::vector<FoundNet> left_out;
};
PrintedNets without_small_bodies(const JobState& state, double scale);

/// Says what was left out for that, if something was.
void add_small_bodies_notice(JobState& state, double scale);

}  // namespace foldwright
