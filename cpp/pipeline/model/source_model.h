#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/values/options.h"
#include "pipeline/values/result.h"
#include "read/model_files.h"
#include "repair/solids.h"

namespace foldwright {

/// A model as its files give it: read, turned upright, repaired, and simplified if that was asked
/// for.
struct SourceModel {
  std::string file;  ///< name of the file that it was read from
  Mesh mesh;
  std::vector<FaceOrigins> origins;  ///< per face of the mesh, see `RepairedModel`
  std::vector<Repair> repairs;
  int file_face_count = 0;  ///< faces of the file as read
  /// Per face of the repaired model: its face of the file, -1 if it fills a hole.
  std::vector<int> source_faces;
  /// Per face of the repaired model the face of `mesh` that stands for it; empty when simplifying
  /// left it alone.
  std::vector<int> face_standins;
  double simplified_deviation = 0;  ///< see `JobResult`
  std::optional<ModelLooks> looks;  ///< see `JobResult`
  std::vector<Notice> notices;
};

/// Reads the model among the files, see `find_model`. `uniter` is needed where bodies are to be
/// united. \throw InputError for files that give no model
SourceModel read_source_model(const std::vector<ModelFile>& files, const ModelOptions& options,
                              const SolidUniter& uniter = {});

/// The model that was read last, for jobs that change a result of the same files.
class ModelMemory {
 public:
  /// As `read_source_model`, which is called only if files or options are others than before.
  /// Models are told apart by the names, sizes and hashes of their files.
  std::shared_ptr<const SourceModel> read(const std::vector<ModelFile>& files,
                                          const ModelOptions& options,
                                          const SolidUniter& uniter = {});

 private:
  std::string key_;
  std::shared_ptr<const SourceModel> model_;
};

}  // namespace foldwright
