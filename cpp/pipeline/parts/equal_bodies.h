#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// Marks every body that is congruent to an earlier one of as many parts (`Component::equal_to`):
/// what is found for that one is carried over instead of being searched again.
void find_equal_bodies(std::vector<Component>& components, const Mesh& mesh);

/// Labels the panels of a body as those of the one that it is equal to. \pre it is equal to one
void carry_labels_of_equal(const std::vector<Component>& components, Component& component);

/// Brings bodies that are equal to others up to date, which are regrouped while they are searched:
/// labels, and numbers for parts that came to be. Whether labels have changed.
bool follow_equal_bodies(JobState& state);

/// Nets of a body, made of those that the state has for the one that it is equal to: with its
/// parts, after its labels were carried. Empty if that has no nets, or not for all of its panels,
/// or one of them overlaps here. Motions that are not certified for the copy are `kUnchecked`.
std::vector<FoundNet> nets_of_equal(const JobState& state, int component);

/// All of that at once, for a job that ends early: the state gets the nets.
void add_nets_of_equal(JobState& state);

}  // namespace foldwright
