#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mesh/input_error.h"
#include "mesh/read_model.h"
#include "mesh/repair.h"
#include "mesh_faults.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

namespace fs = std::filesystem;

/// The folder of shared models: the environment goes before the build's own setting.
fs::path shared_folder() {
  if (const char* folder = std::getenv("FOLDWRIGHT_SHARED")) return folder;
#ifdef FOLDWRIGHT_SHARED
  return FOLDWRIGHT_SHARED;
#else
  return {};
#endif
}

/// Files below a folder of the corpus, in a fixed order.
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

RepairedModel load(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  return repair(read_model(std::as_bytes(std::span(text)), path.filename().string()));
}

TEST(Corpus, HostileFilesAreRefusedInOneSentenceOrMended) {
  const std::vector<fs::path> files = files_below("nasty");
  if (files.empty()) GTEST_SKIP() << "no shared models: set FOLDWRIGHT_SHARED to their folder";
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    try {
      const RepairedModel model = load(path);
      EXPECT_EQ(fault_of(model.mesh), "");
      EXPECT_EQ(bookkeeping_fault_of(model), "");
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_NE(sentence, "");
      EXPECT_NE(error.code(), "");
      EXPECT_EQ(sentence.find('\n'), std::string::npos);
    }
  }
}

TEST(Corpus, GoodModelsAreReadAndMended) {
  int count = 0;
  for (const char* folder : {"models/academic", "models/lowpoly", "models/organic"}) {
    for (const fs::path& path : files_below(folder)) {
      if (path.extension() != ".obj" && path.extension() != ".off") continue;
      SCOPED_TRACE(path.filename().string());
      const RepairedModel model = load(path);
      EXPECT_EQ(fault_of(model.mesh), "");
      EXPECT_EQ(bookkeeping_fault_of(model), "");
      ++count;
    }
  }
  if (count == 0) GTEST_SKIP() << "no shared models: set FOLDWRIGHT_SHARED to their folder";
}

TEST(Corpus, ClosedManifoldsNeedNoRepair) {
  const std::vector<fs::path> files = files_below("models/organic");
  if (files.empty()) GTEST_SKIP() << "no shared models: set FOLDWRIGHT_SHARED to their folder";
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    const RepairedModel model = load(path);
    EXPECT_TRUE(model.repairs.empty());
    EXPECT_EQ(border_edge_count(model.mesh), 0);
    EXPECT_EQ(model.mesh.face_count(), model.source_face_count);
  }
}

}  // namespace
}  // namespace foldwright::testing
