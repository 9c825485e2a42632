#pragma once

#include <span>
#include <string>
#include <vector>

namespace foldwright {

/// A person's name for a part.
struct PartName {
  int part;
  std::string name;
};

/// Names of pieces in the order of gluing, all different.
///
/// The pieces of a part that has a name bear it, with a number behind it where there are several.
/// All others have the letter of their place in the order; where that is taken, the next letter
/// that no piece has. `parts`: per piece.
std::vector<std::string> piece_names(std::span<const int> parts, std::span<const PartName> chosen);

/// What is wrong with a name, as a word for messages; empty when nothing is: it must be told from
/// the numbers of edges, and fit on paper.
std::string fault_of_name(const std::string& name);

}  // namespace foldwright
