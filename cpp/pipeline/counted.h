#pragma once

#include <string>

namespace foldwright {

/// "1 edge", "2 edges"; `thing` is a noun whose plural has an s.
inline std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace foldwright
