#pragma once

#include <emscripten/val.h>

#include <array>
#include <vector>

namespace foldwright {

/// A typed array of JavaScript's own, with these values.
template <class T>
emscripten::val copied(const char* array, const std::vector<T>& values) {
  return emscripten::val::global(array).new_(
      emscripten::typed_memory_view(values.size(), values.data()));
}

inline emscripten::val ints(const std::vector<int>& values) { return copied("Int32Array", values); }
inline emscripten::val doubles(const std::vector<double>& values) {
  return copied("Float64Array", values);
}

/// An array of what the items become.
template <class Items, class Convert>
emscripten::val list(const Items& items, Convert&& convert) {
  emscripten::val array = emscripten::val::array();
  for (const auto& item : items) array.call<void>("push", convert(item));
  return array;
}

/// Rows one after the other.
template <std::size_t N>
std::vector<int> flat(const std::vector<std::array<int, N>>& rows) {
  std::vector<int> values;
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

}  // namespace foldwright
