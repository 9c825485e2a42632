#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// Reads an OBJ, STL (ASCII or binary), OFF or PLY (ASCII, binary of either endianness) file.
///
/// The contents tell the format; only where they show none, the ending of `file_name` does, in any
/// case. An ending of another format is reported as the repair "other-format". Text may be UTF-8,
/// UTF-16 or UTF-32 with or without a byte order mark, or have single bytes of any meaning in its
/// names and comments. Nothing outside `bytes` is touched: of materials, colours and textures only
/// that there are some is kept.
/// \throw InputError for an unknown format, which is named if it is a common one, a damaged or
/// truncated file, an index out of range or a
///        coordinate that is not finite; the sentence names the line or the element.
PolygonSoup read_model(std::span<const std::byte> bytes, std::string_view file_name);

/// Whether the contents, in any encoding, are those of a format that is read.
bool holds_model(std::span<const std::byte> bytes);

/// Whether a file's name ends like that of a format that is read.
bool is_named_as_model(std::string_view file_name);

}  // namespace foldwright
