#include "mesh/ply_header.h"

#include <array>
#include <utility>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

[[noreturn]] void fail(const TextScanner& scanner, const std::string& sentence) {
  throw InputError("bad-header", "line " + std::to_string(scanner.line()) + ": " + sentence);
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
  fail(scanner, quoted(word) + " is not a property type");
}

PlyEncoding parse_encoding(const TextScanner& scanner, std::string_view word) {
  if (word == "ascii") return PlyEncoding::kAscii;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  fail(scanner, quoted(word) + " is not a PLY encoding");
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.word_in_line();
  const std::optional<long long> count = parse_integer(scanner.word_in_line());
  if (!count || *count < 0) {
    fail(scanner, "element " + quoted(element.name) + " needs a count that is not negative");
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
    fail(scanner, "a PLY file begins with 'ply', this one with " + quoted(magic));
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
      if (header.elements.empty()) fail(scanner, "a property stands before any element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword == "end_header") {
      if (!has_format) fail(scanner, "the header ends without a 'format' line");
      scanner.next_line();
      return header;
    } else if (keyword == "comment") {
      header.names_texture |= scanner.word_in_line() == "TextureFile";
    } else if (!keyword.empty() && keyword != "obj_info") {
      fail(scanner, quoted(keyword) + " is not a header keyword");
    }
  }
  throw InputError("truncated", "line " + std::to_string(scanner.line()) +
                                    ": the file ends before 'end_header'");
}

}  // namespace foldwright
