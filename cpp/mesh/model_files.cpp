#include "mesh/model_files.h"

#include <cassert>

#include "mesh/input_error.h"
#include "mesh/model_format.h"
#include "mesh/read_model.h"

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

std::string quoted(const ModelFile& file) { return "'" + file.name + "'"; }

[[noreturn]] void fail_several(std::span<const ModelFile> files,
                               const std::vector<std::size_t>& models) {
  const std::string count = models.size() == 2 ? "two" : std::to_string(models.size());
  const std::string which = models.size() == 2 ? ": " : ", among them ";
  throw InputError("several-models", "there are " + count + " models among the files" + which +
                                         quoted(files[models[0]]) + " and " +
                                         quoted(files[models[1]]) + "; choose one of them");
}

/// Pictures and other companions have foreign formats as well: a model is the better answer.
[[noreturn]] void fail_none(std::span<const ModelFile> files) {
  for (const ModelFile& file : files) {
    const std::string format(foreign_format(file.bytes));
    if (!format.ends_with("model")) continue;
    throw InputError("unknown-format",
                     quoted(file) + " is " + format + ", which is not read" + kFormatsThatAreRead);
  }
  throw InputError("no-model", "none of the " + std::to_string(files.size()) +
                                   " files is a model that is read" + kFormatsThatAreRead);
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
