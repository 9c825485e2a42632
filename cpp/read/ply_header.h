#pragma once

#include <optional>
#include <string>
#include <vector>

#include "read/text_scanner.h"

namespace foldwright {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Bytes that a value of the type takes in a binary file.
int size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  long long count = 0;  ///< as the file says, which may be a lie
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
};

/// Reads from "ply" to "end_header", and leaves the scanner at the beginning of the data.
/// \throw InputError ("bad-header", "truncated") naming the line
PlyHeader read_ply_header(TextScanner& scanner);

}  // namespace foldwright
