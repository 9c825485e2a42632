#include "read/text_encoding.h"

#include <array>
#include <cstdint>
#include <string_view>

#include "mesh/input_error.h"
#include "read/byte_reader.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

struct Layout {
  TextEncoding encoding;
  int unit;    // bytes of a character's first unit
  int offset;  // of the byte of that unit which is not NUL in ASCII
};

// The longer units first: a mark of UTF-32 begins with one of UTF-16.
constexpr std::array<Layout, 4> kLayouts = {{{TextEncoding::kUtf32Le, 4, 0},
                                             {TextEncoding::kUtf32Be, 4, 3},
                                             {TextEncoding::kUtf16Le, 2, 0},
                                             {TextEncoding::kUtf16Be, 2, 1}}};

std::endian endian_of(const Layout& layout) {
  return layout.offset == 0 ? std::endian::little : std::endian::big;
}

char32_t next_unit(ByteReader& reader, int size) {
  return size == 4 ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
}

bool begins_with_mark(std::span<const std::byte> bytes, const Layout& layout) {
  if (bytes.size() < static_cast<std::size_t>(layout.unit)) return false;
  ByteReader reader(bytes, endian_of(layout));
  return next_unit(reader, layout.unit) == 0xFEFF;
}

bool is_ascii_text(char32_t c) { return (c >= '\t' && c <= '\r') || (c >= ' ' && c <= '~'); }

bool begins_with_ascii(std::span<const std::byte> bytes, const Layout& layout) {
  if (bytes.size() < 2 * static_cast<std::size_t>(layout.unit)) return false;
  ByteReader reader(bytes, endian_of(layout));
  const char32_t first = next_unit(reader, layout.unit);
  return is_ascii_text(first) && is_ascii_text(next_unit(reader, layout.unit));
}

const Layout* layout_of(std::span<const std::byte> bytes) {
  for (const auto& test : {begins_with_mark, begins_with_ascii}) {
    for (const Layout& layout : kLayouts) {
      if (test(bytes, layout)) return &layout;
    }
  }
  return nullptr;
}

bool is_high_surrogate(char32_t c) { return c >= 0xD800 && c < 0xDC00; }
bool is_low_surrogate(char32_t c) { return c >= 0xDC00 && c < 0xE000; }

/// \pre a whole unit is left
char32_t next_character(ByteReader& reader, int size) {
  const char32_t first = next_unit(reader, size);
  if (size == 2 && is_high_surrogate(first) && reader.left() >= 2) {
    ByteReader ahead = reader;
    const char32_t second = next_unit(ahead, size);
    if (is_low_surrogate(second)) {
      reader = ahead;
      return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
    }
  }
  const bool is_character =
      first < 0x110000 && !is_high_surrogate(first) && !is_low_surrogate(first);
  return is_character ? first : kReplacement;
}

void append_utf8(std::string& text, char32_t c) {
  if (c < 0x80) {
    text += static_cast<char>(c);
    return;
  }
  const int following = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  constexpr std::array<unsigned, 4> kLeads = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(kLeads[following] | (c >> (6 * following)));
  for (int i = following - 1; i >= 0; --i) {
    text += static_cast<char>(0x80 | ((c >> (6 * i)) & 0x3F));
  }
}

}  // namespace

TextEncoding text_encoding(std::span<const std::byte> bytes) {
  const Layout* layout = layout_of(bytes);
  return layout == nullptr ? TextEncoding::kUtf8 : layout->encoding;
}

std::span<const std::byte> to_utf8(std::span<const std::byte> bytes, std::string& storage) {
  const Layout* layout = layout_of(bytes);
  if (layout == nullptr) return bytes;
  storage.clear();
  storage.reserve(bytes.size() / layout->unit);
  ByteReader reader(bytes, endian_of(*layout));
  while (reader.left() >= static_cast<std::size_t>(layout->unit)) {
    append_utf8(storage, next_character(reader, layout->unit));
  }
  if (reader.left() > 0) append_utf8(storage, kReplacement);
  return std::as_bytes(std::span(storage.data(), storage.size()));
}

void refuse_nul(std::span<const std::byte> text) {
  const std::string_view view(reinterpret_cast<const char*>(text.data()), text.size());
  const std::size_t nul = view.find('\0');
  if (nul == std::string_view::npos) return;
  TextScanner scanner(text.first(nul + 1));
  while (scanner.next_line()) {
  }
  throw InputError("bad-text", Place{"line", scanner.line()});
}

}  // namespace foldwright
