#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// Reads an OBJ, STL (ASCII or binary), OFF or PLY (ASCII, binary of either endianness) file.
///
/// The format comes from the ending of `file_name`, in any case; the contents decide between the
/// two kinds of STL. Nothing outside `bytes` is touched: materials and textures are ignored.
/// \throw InputError for an unknown format, a damaged or truncated file, an index out of range or a
///        coordinate that is not finite; the sentence names the line or the element.
PolygonSoup read_model(std::span<const std::byte> bytes, std::string_view file_name);

}  // namespace foldwright
