#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "repair/repair.h"

/// Models too large or too foreign to commit: they lie in a folder beside the repository.
namespace foldwright::testing {

/// What a test says that skips itself.
inline constexpr const char* kNoSharedModels =
    "no shared models: set FOLDWRIGHT_SHARED to their folder";

/// The folder of shared models: the environment goes before the build's own setting.
/// \throw std::runtime_error when it is missing and CI is set: tests must not vanish there
std::filesystem::path shared_folder();

/// Files below a folder of the shared models, in a fixed order; none when it is missing.
std::vector<std::filesystem::path> files_below(const char* folder);

/// All bytes of a file.
std::string bytes_of(const std::filesystem::path& path);

/// Reads and repairs a model.
RepairedModel load(const std::filesystem::path& path);

}  // namespace foldwright::testing
