#include "data_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace foldwright::testing {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry);
  std::sort(files.begin(), files.end());
  return files;
}

/// A line of the manifest: "NAME OUTCOME: what was wrong".
Reproduction parse_line(const std::string& line, const fs::path& folder) {
  std::istringstream words(line);
  std::string name, outcome;
  words >> name >> outcome;
  if (outcome.empty() || outcome.back() != ':') {
    throw std::runtime_error("no outcome in this line of the manifest: " + line);
  }
  outcome.pop_back();
  return {folder / name, outcome};
}

}  // namespace

std::vector<fs::path> corpus_files() {
  return files_in(fs::path(FOLDWRIGHT_TESTS) / "data/corpus");
}

std::vector<Reproduction> reproductions() {
  const fs::path folder = fs::path(FOLDWRIGHT_TESTS) / "repro";
  std::ifstream manifest(folder / "manifest.txt");
  std::vector<Reproduction> found;
  for (std::string line; std::getline(manifest, line);) {
    if (!line.starts_with('#')) found.push_back(parse_line(line, folder));
  }
  std::vector<fs::path> listed = {folder / "manifest.txt"};
  for (const Reproduction& reproduction : found) listed.push_back(reproduction.file);
  std::sort(listed.begin(), listed.end());
  if (listed != files_in(folder)) {
    throw std::runtime_error("the manifest of tests/repro does not list the files beside it");
  }
  return found;
}

}  // namespace foldwright::testing
