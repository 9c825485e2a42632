#pragma once

#include <string>
#include <string_view>

#include "read/text_encoding.h"

/// Text in encodings that programs on Windows like to write.
namespace foldwright::testing {

inline constexpr TextEncoding kWideEncodings[] = {TextEncoding::kUtf16Le, TextEncoding::kUtf16Be,
                                                  TextEncoding::kUtf32Le, TextEncoding::kUtf32Be};

inline void append_unit(std::string& bytes, char32_t unit, int size, bool big_endian) {
  for (int i = 0; i < size; ++i) {
    const int shift = 8 * (big_endian ? size - 1 - i : i);
    bytes += static_cast<char>((unit >> shift) & 0xFF);
  }
}

/// The text in one of the wide encodings, without a mark of its own.
inline std::string encoded(std::u32string_view text, TextEncoding encoding) {
  const bool big_endian = encoding == TextEncoding::kUtf16Be || encoding == TextEncoding::kUtf32Be;
  const bool is_utf16 = encoding == TextEncoding::kUtf16Le || encoding == TextEncoding::kUtf16Be;
  std::string bytes;
  for (const char32_t c : text) {
    if (is_utf16 && c >= 0x10000) {
      append_unit(bytes, 0xD800 + ((c - 0x10000) >> 10), 2, big_endian);
      append_unit(bytes, 0xDC00 + ((c - 0x10000) & 0x3FF), 2, big_endian);
    } else {
      append_unit(bytes, c, is_utf16 ? 2 : 4, big_endian);
    }
  }
  return bytes;
}

/// ASCII text in one of the wide encodings.
inline std::string encoded_ascii(std::string_view text, TextEncoding encoding) {
  return encoded(std::u32string(text.begin(), text.end()), encoding);
}

}  // namespace foldwright::testing
