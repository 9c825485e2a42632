#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Files that lie in `tests` and belong to the repository.
namespace foldwright::testing {

/// Our own small models of every format, all of them whole.
std::vector<std::filesystem::path> corpus_files();

/// A file that once went wrong, and what comes of it now.
struct Reproduction {
  std::filesystem::path file;
  std::string outcome;  ///< "nets", or the code with which it is refused
};

/// The files of `tests/repro`, as its manifest lists them.
/// \throw std::runtime_error when the manifest lacks a file or names one that is missing
std::vector<Reproduction> reproductions();

}  // namespace foldwright::testing
