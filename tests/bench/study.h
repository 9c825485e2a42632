#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "shared_models.h"

namespace foldwright::testing {

/// The models that studies look at: organic ones of different build.
inline constexpr const char* kStudyModels[] = {"spot", "koala", "cat"};

/// One of the shared organic models, simplified to so many faces.
inline std::filesystem::path organic_model(const std::string& name, int faces) {
  return shared_folder() / "models/organic" / (name + "_" + std::to_string(faces) + ".obj");
}

/// A number with so many decimals.
inline std::string decimal(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// A table of a study, as Markdown.
class Table {
 public:
  explicit Table(std::vector<std::string> columns) { rows_.push_back(std::move(columns)); }

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const {
    std::string text;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      text += line(rows_[row]);
      if (row == 0) text += line(std::vector<std::string>(rows_[0].size(), "---"));
    }
    return text;
  }

 private:
  static std::string line(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
  }

  std::vector<std::vector<std::string>> rows_;
};

/// Where a study leaves its tables and pictures.
class StudyFolder {
 public:
  /// The folder that the command line names, else `build/studies`; made when it is missing.
  explicit StudyFolder(std::span<char*> arguments)
      : folder_(arguments.size() > 1 ? arguments[1] : "build/studies") {
    std::filesystem::create_directories(folder_);
  }

  /// Writes a file. \throw std::runtime_error when that cannot be done
  void save(const std::string& name, const std::string& text) const {
    std::ofstream file(folder_ / name, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + (folder_ / name).string());
  }

  /// Writes a table below its heading, and prints both.
  void save(const std::string& name, const std::string& heading, const Table& table) const {
    const std::string text = heading + "\n\n" + table.text();
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
    save(name, text);
  }

 private:
  std::filesystem::path folder_;
};

/// Whether there are models to study; says so where there are none.
inline bool has_study_models(const char* study) {
  if (!files_below("models/organic").empty()) return true;
  std::printf("%s: %s\n", study, kNoSharedModels);
  return false;
}

}  // namespace foldwright::testing
