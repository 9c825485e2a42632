#pragma once

#include <cstddef>
#include <span>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// The readers behind `read_model`, one per format. Each reads only inside `bytes`, allocates no
/// more than a small multiple of their number, and throws InputError for what it cannot read.

/// Wavefront OBJ: vertices and faces; everything else is skipped.
PolygonSoup read_obj(std::span<const std::byte> bytes);

/// STL of either kind; a binary file is recognised by its size, since its header may say "solid".
PolygonSoup read_stl(std::span<const std::byte> bytes);

/// OFF with its prefixes ST, C and N, one vertex and one face per line. Colours and normals are
/// skipped. The header may be missing.
PolygonSoup read_off(std::span<const std::byte> bytes);

/// PLY, ASCII or binary of either endianness, with any elements and properties.
PolygonSoup read_ply(std::span<const std::byte> bytes);

}  // namespace foldwright
