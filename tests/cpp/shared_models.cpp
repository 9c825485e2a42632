#include "shared_models.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "read/read_model.h"

namespace foldwright::testing {

namespace fs = std::filesystem;

fs::path shared_folder() {
  const char* set = std::getenv("FOLDWRIGHT_SHARED");
  fs::path folder = set != nullptr ? set : FOLDWRIGHT_SHARED;
  // Tests must not vanish there.
  if (std::getenv("CI") != nullptr && !fs::exists(folder)) {
    throw std::runtime_error("CI is set, but " + folder.string() + " is missing");
  }
  return folder;
}

std::vector<fs::path> files_below(const char* folder) {
  std::vector<fs::path> files;
  const fs::path root = shared_folder() / folder;
  if (!fs::exists(root)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

RepairedModel load(const fs::path& path) {
  const std::string text = bytes_of(path);
  return repair(read_model(std::as_bytes(std::span(text)), path.filename().string()));
}

}  // namespace foldwright::testing
