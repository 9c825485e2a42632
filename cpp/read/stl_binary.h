#pragma once

#include <cstddef>
#include <span>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// Whether the size of the file is that of a binary STL with as many triangles as its header says.
bool has_size_of_binary_stl(std::span<const std::byte> bytes);

/// Reads binary STL. Normals and attributes, in which some programs keep colours, are skipped. A
/// count that does not match whole triangles up to the end of the file is reported, not believed.
/// \throw InputError ("truncated" in the middle of a triangle, and as SoupBuilder)
PolygonSoup read_stl_binary(std::span<const std::byte> bytes);

}  // namespace foldwright
