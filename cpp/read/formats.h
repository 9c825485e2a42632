#pragma once

#include <cstddef>
#include <span>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// The readers behind `read_model`, one per format. Each reads only inside `bytes`, allocates no
/// more than a small multiple of their number, and throws InputError for what it cannot read.

/// Wavefront OBJ: vertices and faces. Points, lines and free forms are reported as ignored;
/// everything else is skipped.
PolygonSoup read_obj(std::span<const std::byte> bytes);

/// STL of either kind. A binary file is recognised by its size, or else by NUL bytes where no facet
/// stands in text, since its header may say "solid".
PolygonSoup read_stl(std::span<const std::byte> bytes);

/// OFF, text or binary, with its prefixes ST, C, N, 4 and n, if the dimension is 3. Colours,
/// normals and texture coordinates are skipped. Lines may be broken anywhere, the header may be
/// missing.
PolygonSoup read_off(std::span<const std::byte> bytes);

/// PLY, ASCII or binary of either endianness, with any elements and properties; faces and
/// triangle strips are read.
PolygonSoup read_ply(std::span<const std::byte> bytes);

}  // namespace foldwright
