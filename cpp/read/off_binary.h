#pragma once

#include <cstddef>
#include <span>

#include "mesh/polygon_soup.h"
#include "read/off_header.h"

namespace foldwright {

/// Reads the numbers of a binary OFF file, which are big-endian; `bytes` begin after its header.
/// \throw InputError ("bad-header", "truncated", and as SoupBuilder)
PolygonSoup read_off_binary(std::span<const std::byte> bytes, const OffLayout& layout);

}  // namespace foldwright
