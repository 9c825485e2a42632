#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace foldwright {

/// A file as it was handed over.
struct ModelFile {
  std::string name;  ///< may have folders before it: "textures/wood.png"
  std::vector<std::byte> bytes;
};

/// Index of the model among the files that came together; the others are its companions, such as
/// materials and pictures.
///
/// It is the one whose contents show a format that is read; if there is none, the one whose name
/// ends like one. A single file always is the model. \throw InputError ("several-models",
/// "no-model", "unknown-format") unless there is just one; it names the files \pre there is a file
std::size_t find_model(std::span<const ModelFile> files);

}  // namespace foldwright
