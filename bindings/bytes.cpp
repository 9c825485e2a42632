#include "bytes.h"

#include <emscripten/bind.h>

#include <cstdint>

namespace foldwright {

using emscripten::val;

std::vector<std::byte> bytes_from(const val& array) {
  std::vector<std::byte> bytes(array["length"].as<std::size_t>());
  val(emscripten::typed_memory_view(bytes.size(), reinterpret_cast<std::uint8_t*>(bytes.data())))
      .call<void>("set", array);
  return bytes;
}

val to_array(const std::vector<std::byte>& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return val::global("Uint8Array").new_(emscripten::typed_memory_view(bytes.size(), data));
}

}  // namespace foldwright
