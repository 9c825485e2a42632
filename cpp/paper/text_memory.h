#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>

#include "paper/piece_texts.h"

namespace foldwright {

/// Everything that the texts of a net depend on, as bytes: equal tasks have equal bytes.
std::string bytes_of(const PieceTextTask& task);

/// Texts that nets had before. An edit leaves most nets as they are, and finding places for texts
/// is half of its time. Holds 16 MiB at most; what was not asked for lately goes first.
class TextMemory {
 public:
  /// What was kept under these bytes, or null. It stays until the next call of `keep`.
  const PieceTexts* find(const std::string& key);
  void keep(std::string key, PieceTexts texts);

 private:
  using Kept = std::unordered_map<std::string, PieceTexts>;
  Kept recent_, older_;
  std::size_t recent_bytes_ = 0;
};

}  // namespace foldwright
