#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace foldwright {

enum class ModelFormat { kObj, kStl, kOff, kPly };

/// The format that the contents show, whatever the file's name: the first words of STL, OFF and
/// PLY, the size of binary STL, and for OBJ, which has no header, a line that gives a vertex. Empty
/// when nothing shows, as for STL with a wrong count and OFF without a header. Text must be UTF-8.
std::optional<ModelFormat> format_of_contents(std::span<const std::byte> bytes);

/// A word for a format that is known by its first bytes, but not read: "glb". Empty when the
/// contents are of no such format.
std::string_view foreign_format(std::span<const std::byte> bytes);

/// Whether such a word is that of a model, and not of a picture, a document or an archive.
bool is_foreign_model(std::string_view format);

}  // namespace foldwright
