#pragma once

#include <cstddef>
#include <span>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// Whether a text begins like ASCII STL: with a facet, or with "solid" and a facet after it. The
/// beginning of a file is enough.
bool is_stl_text(std::span<const std::byte> bytes);

/// Reads ASCII STL in any case, with any number of solids of any names. The words around the three
/// vertices of a triangle may be missing or be written apart ("end facet"); normals and lines with
/// colours are skipped.
/// \throw InputError ("bad-syntax", "bad-text", "truncated", and as SoupBuilder) naming the line
PolygonSoup read_stl_text(std::span<const std::byte> bytes);

}  // namespace foldwright
