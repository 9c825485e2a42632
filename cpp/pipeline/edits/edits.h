#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// Numbers of parts after some edits.
struct EditedNumbers {
  std::vector<std::vector<int>> of_edit;  ///< by edit: of the parts that it makes, ascending
  std::vector<int> of_part;  ///< by part before: of one that no edit names; otherwise -1
  int count = 0;             ///< of all parts
};

/// Numbers the parts after `edits` of a result with `count` parts.
///
/// A part that no edit names keeps its number. What an edit makes takes the numbers of what it was
/// made from, the lower ones first; then those that other edits set free, then new ones. Numbers
/// that stay free are filled with the parts of the highest numbers.
/// \pre no part is named twice
EditedNumbers number_parts(int count, std::span<const PartEdit> edits);

/// Names of the parts after `edits`, from those before; `numbers`: what `number_parts` gives.
///
/// A part that no edit names keeps its name, and so does what becomes one part again, if just one
/// of the parts that it is made of has a name. All other names go with their parts.
std::vector<PartName> carry_names(std::span<const PartName> names, std::span<const PartEdit> edits,
                                  const EditedNumbers& numbers);

/// Begins the job with its `start` instead of the bodies of the model: each edit becomes a
/// component with the number of parts that it asks for, and every other part one with its nets.
/// \throw InputError "bad-edit" for an edit that cannot be made, "bad-start" for a result of
/// another model
void start_from_earlier(JobState& state);

}  // namespace foldwright
