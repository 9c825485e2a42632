#include "read/model_files.h"

#include <cassert>

#include "mesh/input_error.h"
#include "read/model_format.h"
#include "read/read_model.h"

namespace foldwright {
namespace {

template <class Predicate>
std::vector<std::size_t> indices_of(std::span<const ModelFile> files, Predicate&& is_meant) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (is_meant(files[i])) found.push_back(i);
  }
  return found;
}

[[noreturn]] void fail_several(std::span<const ModelFile> files,
                               const std::vector<std::size_t>& models) {
  throw InputError("several-models", {{"count", models.size()},
                                      {"first", files[models[0]].name},
                                      {"second", files[models[1]].name}});
}

/// Pictures and other companions have foreign formats as well: a model is the better answer.
[[noreturn]] void fail_none(std::span<const ModelFile> files) {
  for (const ModelFile& file : files) {
    const std::string format(foreign_format(file.bytes));
    if (!is_foreign_model(format)) continue;
    throw InputError("unknown-format", {{"what", "file"}, {"file", file.name}, {"format", format}});
  }
  throw InputError("no-model", {{"count", files.size()}});
}

}  // namespace

std::size_t find_model(std::span<const ModelFile> files) {
  assert(!files.empty());
  if (files.size() == 1) return 0;
  std::vector<std::size_t> models =
      indices_of(files, [](const ModelFile& file) { return holds_model(file.bytes); });
  if (models.empty()) {
    models = indices_of(files, [](const ModelFile& file) { return is_named_as_model(file.name); });
  }
  if (models.empty()) fail_none(files);
  if (models.size() > 1) fail_several(files, models);
  return models.front();
}

}  // namespace foldwright
