#include "read/ply_header.h"

#include <array>
#include <utility>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

[[noreturn]] void fail(const TextScanner& scanner, const char* what, Parameters more = {}) {
  more.insert(more.begin(), {"what", what});
  throw InputError("bad-header", Place{"line", scanner.line()}, std::move(more));
}

PlyType parse_type(const TextScanner& scanner, std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> kNames = {{
      {"char", PlyType::kInt8},
      {"int8", PlyType::kInt8},
      {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},
      {"short", PlyType::kInt16},
      {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},
      {"uint16", PlyType::kUint16},
      {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},
      {"uint", PlyType::kUint32},
      {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},
      {"float32", PlyType::kFloat32},
      {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64},
  }};
  for (const auto& [name, type] : kNames) {
    if (word == name) return type;
  }
  fail(scanner, "property-type", {{"word", excerpt(word)}});
}

PlyEncoding parse_encoding(const TextScanner& scanner, std::string_view word) {
  if (word == "ascii") return PlyEncoding::kAscii;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  fail(scanner, "encoding", {{"word", excerpt(word)}});
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.word_in_line();
  const std::optional<long long> count = parse_integer(scanner.word_in_line());
  if (!count || *count < 0) {
    fail(scanner, "element-count", {{"element", excerpt(element.name)}});
  }
  element.count = *count;
  return element;
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property;
  std::string_view type = scanner.word_in_line();
  if (type == "list") {
    property.count_type = parse_type(scanner, scanner.word_in_line());
    type = scanner.word_in_line();
  }
  property.type = parse_type(scanner, type);
  property.name = scanner.word_in_line();
  return property;
}

}  // namespace

int size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

PlyHeader read_ply_header(TextScanner& scanner) {
  if (const std::string_view magic = scanner.word_in_line(); magic != "ply") {
    fail(scanner, "ply-magic", {{"word", excerpt(magic)}});
  }
  PlyHeader header;
  bool has_format = false;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word_in_line();
    if (keyword == "format") {
      header.encoding = parse_encoding(scanner, scanner.word_in_line());
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(scanner));
    } else if (keyword == "property") {
      if (header.elements.empty()) fail(scanner, "property-first");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword == "end_header") {
      if (!has_format) fail(scanner, "no-format");
      scanner.next_line();
      return header;
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      fail(scanner, "keyword", {{"word", excerpt(keyword)}});
    }
  }
  throw InputError("truncated", Place{"line", scanner.line()}, {{"what", "ply-header"}});
}

}  // namespace foldwright
