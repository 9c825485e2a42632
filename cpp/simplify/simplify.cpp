#include "simplify/simplify.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/mirror.h"
#include "mesh/nearest_face.h"
#include "simplify/edge_collapse.h"
#include "simplify/mirror_half.h"

namespace foldwright {
namespace {

// The mean distance of a surface that mirrors itself from its image, in radii: what `find_mirror`
// is off for surfaces that do, with room for rounded coordinates. Whether it does is asked anew.
constexpr double kMirrorError = 0.005;

std::optional<MirrorHalf> mirror_half(const Mesh& mesh) {
  std::vector<int> all(mesh.face_count());
  std::iota(all.begin(), all.end(), 0);
  const std::optional<Mirror> mirror = find_mirror(mesh, all, kMirrorError);
  if (!mirror || !mirrors_itself(mesh, *mirror)) return std::nullopt;
  return half_in_front(mesh, *mirror);
}

Mesh simplify_half(const MirrorHalf& half, const SimplifyOptions& options) {
  std::vector<int> regions;
  if (!options.regions.empty()) {
    for (const int face : half.mesh.source_faces) regions.push_back(options.regions[face]);
  }
  return with_image(collapse_edges(half.mesh, {.target_faces = options.target_faces / 2,
                                               .regions = regions,
                                               .plane = half.plane,
                                               .keep_apart = options.keep_apart}),
                    half.plane);
}

Mesh simplify_whole(const Mesh& mesh, const SimplifyOptions& options) {
  CollapsedMesh collapsed = collapse_edges(mesh, {.target_faces = options.target_faces,
                                                  .regions = options.regions,
                                                  .keep_apart = options.keep_apart});
  return make_mesh(std::move(collapsed.positions), std::move(collapsed.faces));
}

/// A mesh in another unit: errors are fourth powers of lengths, which neither under- nor overflow
/// in units of the mean edge, whatever the model's unit.
Mesh scaled(Mesh mesh, double scale) {
  for (Vec3& p : mesh.positions) p *= scale;
  return mesh;
}

}  // namespace

Mesh simplify(const Mesh& mesh, const SimplifyOptions& options) {
  assert(options.regions.empty() || options.regions.size() == mesh.faces.size());
  if (mesh.face_count() <= options.target_faces) return mesh;
  // A power of two, so that no coordinate is rounded.
  const double unit = std::exp2(std::ilogb(mean_edge_length(mesh)));
  const Mesh fine = scaled(mesh, 1 / unit);
  const auto half = options.keep_mirror ? mirror_half(fine) : std::nullopt;
  Mesh result = scaled(half ? simplify_half(*half, options) : simplify_whole(fine, options), unit);
  const std::vector<int> nearest = nearest_faces(result, mesh);
  for (int face = 0; face < result.face_count(); ++face) {
    result.source_faces[face] = mesh.source_faces[nearest[face]];
  }
  return result;
}

}  // namespace foldwright
