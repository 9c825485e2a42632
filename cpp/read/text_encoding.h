#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace foldwright {

enum class TextEncoding { kUtf8, kUtf16Le, kUtf16Be, kUtf32Le, kUtf32Be };

/// The encoding of a text file, from its byte order mark or else from where NUL bytes lie among its
/// first two characters, which are ASCII in every format that is read. UTF-8 stands for all
/// encodings whose ASCII characters are single bytes, such as Latin-1.
TextEncoding text_encoding(std::span<const std::byte> bytes);

/// The text as UTF-8: `bytes` themselves when they are that already, else converted into `storage`,
/// which must outlive the result. What is no character becomes U+FFFD; a byte order mark stays.
std::span<const std::byte> to_utf8(std::span<const std::byte> bytes, std::string& storage);

/// Refuses text with a NUL byte, which is damaged or no text: as a blank it would split numbers.
/// \throw InputError ("bad-text") naming the line
void refuse_nul(std::span<const std::byte> text);

}  // namespace foldwright
