#pragma once

#include <span>
#include <utility>
#include <vector>

#include "unfold/net.h"

namespace foldwright {

/// The order in which nets become the model: the largest first, then always the one with the
/// longest border to what is already together, so that every piece finds firm ground; of pieces
/// without one the largest, of equals the first. Indices of nets.
std::vector<int> gluing_order(std::span<const Net> nets);

/// The items in another order. `order`: the index of each, once
template <class T>
std::vector<T> in_order(std::vector<T> items, std::span<const int> order) {
  std::vector<T> sorted;
  sorted.reserve(items.size());
  for (const int i : order) sorted.push_back(std::move(items[i]));
  return sorted;
}

}  // namespace foldwright
