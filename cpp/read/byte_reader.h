#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

namespace foldwright {

/// Reads numbers of either endianness from the front of a piece of memory.
class ByteReader {
 public:
  ByteReader(std::span<const std::byte> bytes, std::endian endian)
      : bytes_(bytes), endian_(endian) {}

  std::size_t left() const { return bytes_.size(); }

  /// \pre count <= left()
  void skip(std::size_t count) { bytes_ = bytes_.subspan(count); }

  /// Next value of an arithmetic type. \pre sizeof(T) <= left()
  template <typename T>
  T read() {
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data(), sizeof(T));
    if (endian_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    skip(sizeof(T));
    return std::bit_cast<T>(raw);
  }

 private:
  std::span<const std::byte> bytes_;
  std::endian endian_;
};

}  // namespace foldwright
