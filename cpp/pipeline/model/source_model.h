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

/// The model that was read last, whole and simplified, for jobs that change a result of the same
/// files, or ask for another number of faces.
class ModelMemory {
 public:
  /// As `read_source_model`. Files are read and repaired only if they or other options than
  /// `faces` are others than before; they are told apart by names, sizes and hashes. Holds one
  /// whole model and one simplified one: some 250 bytes per face.
  std::shared_ptr<const SourceModel> read(const std::vector<ModelFile>& files,
                                          const ModelOptions& options,
                                          const SolidUniter& uniter = {});

 private:
  std::string key_;  ///< of the whole model
  std::shared_ptr<const SourceModel> whole_;
  std::shared_ptr<const SourceModel> simple_;  ///< null: none was asked for
  int faces_ = 0;                              ///< that the simplified one was asked for
};

}  // namespace foldwright
