#include "pipeline/model/source_model.h"

#include <utility>

#include "mesh/carry_origins.h"
#include "mesh/look_regions.h"
#include "mesh/nearest_face.h"
#include "read/read_model.h"
#include "read/turn_up.h"
#include "repair/joints.h"
#include "repair/repair.h"
#include "simplify/simplify.h"

namespace foldwright {
namespace {

Axis up_of(const PolygonSoup& soup, Up asked) {
  switch (asked) {
    case Up::kX:
      return Axis::kX;
    case Up::kY:
      return Axis::kY;
    case Up::kZ:
      return Axis::kZ;
    case Up::kGuess:
      break;
  }
  return soup.usual_up;
}

/// Tells what of the file's looks is not printed.
void tell_looks(const PolygonSoup& soup, SourceModel& model) {
  if (soup.looks.has_colour_numbers) model.notices.push_back({"colour-numbers"});
}

/// What the file says of the looks of the repaired model.
std::optional<ModelLooks> looks_of(const PolygonSoup& soup, const RepairedModel& model) {
  if (soup.looks.empty()) return std::nullopt;
  return ModelLooks{.faces = carry_looks(soup.looks, soup.first_corner, model.origins),
                    .original = std::nullopt,
                    .material_names = soup.looks.material_names,
                    .libraries = soup.looks.libraries};
}

/// Tells which files came along that nothing is made of.
void tell_ignored(const std::vector<ModelFile>& files, std::size_t chosen, SourceModel& model) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i != chosen) names.push_back(files[i].name);
  }
  if (!names.empty()) model.notices.push_back({"files-ignored", {{"files", names}}});
}

/// The files' model with y up. A guess is told where the model was turned for it.
PolygonSoup read_upright(const std::vector<ModelFile>& files, Up asked, SourceModel& model) {
  const std::size_t chosen = find_model(files);
  model.file = files[chosen].name;
  PolygonSoup soup = read_model(files[chosen].bytes, model.file);
  tell_ignored(files, chosen, model);
  tell_looks(soup, model);
  const Axis up = up_of(soup, asked);
  turn_up(soup.positions, up);
  if (asked == Up::kGuess && up != Axis::kY) model.notices.push_back({"up-guessed"});
  return soup;
}

/// A simpler model of about `wanted` faces, which remembers which face stands for which.
SourceModel simplified(const SourceModel& whole, int wanted) {
  SourceModel model;
  model.file = whole.file;
  model.repairs = whole.repairs;
  model.file_face_count = whole.file_face_count;
  model.source_faces = whole.source_faces;
  model.looks = whole.looks;
  model.notices = whole.notices;
  const Mesh& mesh = whole.mesh;
  const std::vector<int> regions =
      model.looks ? look_regions(mesh, model.looks->faces) : std::vector<int>{};
  model.mesh = simplify(
      mesh, {.target_faces = wanted, .regions = regions, .keep_mirror = true, .keep_apart = true});
  model.face_standins = nearest_faces(mesh, model.mesh);
  model.origins = carry_origins(mesh, whole.origins, model.mesh);
  model.simplified_deviation = largest_deviation(mesh, model.mesh);
  model.mesh.joints = find_joints(model.mesh);
  if (model.looks) model.looks->original = {mesh.positions, mesh.faces};
  const auto lost = static_cast<int>(mesh.joints.size() - model.mesh.joints.size());
  if (lost > 0) model.notices.push_back({"joints-lost", {{"count", lost}}});
  if (model.mesh.face_count() > wanted) {
    model.notices.push_back({"faces-above-wish", {{"faces", model.mesh.face_count()}}});
  }
  return model;
}

bool is_too_fine(const SourceModel& model, int wanted) {
  return wanted > 0 && model.mesh.face_count() > wanted;
}

/// The model among the files as it is after repair, however many faces it has.
SourceModel read_whole(const std::vector<ModelFile>& files, const ModelOptions& options,
                       const SolidUniter& uniter) {
  SourceModel model;
  const PolygonSoup soup = read_upright(files, options.up, model);
  RepairedModel repaired = repair(soup, {.fill_holes = options.fill_holes / 100,
                                         .drop_inner = options.drop_inner,
                                         .unite = options.unite,
                                         .uniter = uniter,
                                         .off = options.off});
  model.looks = looks_of(soup, repaired);
  model.mesh = std::move(repaired.mesh);
  model.origins = std::move(repaired.origins);
  model.repairs = std::move(repaired.repairs);
  model.file_face_count = repaired.source_face_count;
  model.source_faces = model.mesh.source_faces;
  return model;
}

/// Whatever the whole model depends on. Bytes are told apart by their hash: copies would cost as
/// much memory again.
std::string key_of(const std::vector<ModelFile>& files, const ModelOptions& options) {
  std::string key = std::to_string(static_cast<int>(options.up)) + ' ' +
                    std::to_string(options.fill_holes) + ' ' + std::to_string(options.drop_inner) +
                    ' ' + std::to_string(options.unite) + ' ' + options.off.to_string();
  for (const ModelFile& file : files) {
    const auto* bytes = reinterpret_cast<const char*>(file.bytes.data());
    key += '\n' + file.name + '\n' + std::to_string(file.bytes.size()) + ' ' +
           hash_of({bytes, file.bytes.size()});
  }
  return key;
}

}  // namespace

SourceModel read_source_model(const std::vector<ModelFile>& files, const ModelOptions& options,
                              const SolidUniter& uniter) {
  SourceModel whole = read_whole(files, options, uniter);
  return is_too_fine(whole, options.faces) ? simplified(whole, options.faces) : std::move(whole);
}

std::shared_ptr<const SourceModel> ModelMemory::read(const std::vector<ModelFile>& files,
                                                     const ModelOptions& options,
                                                     const SolidUniter& uniter) {
  std::string key = key_of(files, options);
  if (!whole_ || key != key_) {
    simple_.reset();
    whole_.reset();
    whole_ = std::make_shared<const SourceModel>(read_whole(files, options, uniter));
    key_ = std::move(key);
  }
  if (!is_too_fine(*whole_, options.faces)) return whole_;
  if (!simple_ || faces_ != options.faces) {
    simple_.reset();
    simple_ = std::make_shared<const SourceModel>(simplified(*whole_, options.faces));
    faces_ = options.faces;
  }
  return simple_;
}

}  // namespace foldwright
