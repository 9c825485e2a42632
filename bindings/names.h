#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "pipeline/values/result.h"

namespace foldwright {

/// A word that JavaScript has for a value.
template <class Enum>
struct Name {
  const char* text;
  Enum value;
};

/// Throws std::invalid_argument for a word that is not among them.
template <class Enum>
Enum from_name(std::span<const Name<Enum>> names, const std::string& text) {
  for (const auto& name : names) {
    if (text == name.text) return name.value;
  }
  throw std::invalid_argument("unknown word: " + text);
}

template <class Enum>
std::string name_of(std::span<const Name<Enum>> names, Enum value) {
  for (const auto& name : names) {
    if (value == name.value) return name.text;
  }
  throw std::logic_error("a value without a name");
}

inline constexpr Name<Cause> kCauses[] = {{"part", Cause::kPart},
                                          {"no-net", Cause::kNoNet},
                                          {"no-motion", Cause::kNoMotion},
                                          {"sheet", Cause::kSheet},
                                          {"edit", Cause::kEdit}};
inline constexpr Name<Folding> kFoldings[] = {{"unchecked", Folding::kUnchecked},
                                              {"no", Folding::kNone},
                                              {"line", Folding::kLine},
                                              {"waypoints", Folding::kWaypoints}};

}  // namespace foldwright
