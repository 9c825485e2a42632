#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <vector>

namespace foldwright {

/// Copies a Uint8Array into the engine's memory.
std::vector<std::byte> bytes_from(const emscripten::val& array);

/// Copies bytes into a new Uint8Array that JavaScript owns.
emscripten::val to_array(const std::vector<std::byte>& bytes);

}  // namespace foldwright
