#include <algorithm>

#include "read/formats.h"
#include "read/stl_binary.h"
#include "read/stl_text.h"

namespace foldwright {

PolygonSoup read_stl(std::span<const std::byte> bytes) {
  if (has_size_of_binary_stl(bytes)) return read_stl_binary(bytes);
  // Many binary headers begin with "solid" as well, but the first facet of a text comes soon, and
  // no binary file lacks NUL bytes in its header, its count and its first triangles.
  constexpr std::size_t kSample = 512;
  const std::span sample = bytes.first(std::min(bytes.size(), kSample));
  const bool has_nul = std::find(sample.begin(), sample.end(), std::byte{0}) != sample.end();
  return has_nul && !is_stl_text(sample) ? read_stl_binary(bytes) : read_stl_text(bytes);
}

}  // namespace foldwright
