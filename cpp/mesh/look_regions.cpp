#include "mesh/look_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

// Colours that differ by less, of 255, are one to the eye.
constexpr int kSameColour = 4;

// Places in a picture that differ by less, of its width, are one up to rounding.
constexpr float kSamePlace = 1e-3f;

bool are_same(const Rgb& a, const Rgb& b) {
  return std::ranges::equal(a, b, [](int x, int y) { return std::abs(x - y) <= kSameColour; });
}

/// A place that is none, as NaN stands for, is not the same as one that is.
bool are_same(const PicturePlace& a, const PicturePlace& b) {
  return std::ranges::equal(a, b, [](float x, float y) {
    return std::isnan(x) ? std::isnan(y) : std::abs(x - y) <= kSamePlace;
  });
}

/// Index of a vertex's corner of a face, among all corners.
int corner_at(const Mesh& mesh, int face, int vertex) {
  const auto& corners = mesh.faces[face];
  return 3 * face + static_cast<int>(std::ranges::find(corners, vertex) - corners.begin());
}

bool jump_at(const Mesh& mesh, const FaceLooks& looks, const Mesh::Edge& edge) {
  const auto [face, other] = edge.faces;
  if (!looks.materials.empty() && looks.materials[face] != looks.materials[other]) return true;
  return std::ranges::any_of(edge.vertices, [&](int vertex) {
    const int a = corner_at(mesh, face, vertex);
    const int b = corner_at(mesh, other, vertex);
    return (!looks.colours.empty() && !are_same(looks.colours[a], looks.colours[b])) ||
           (!looks.places.empty() && !are_same(looks.places[a], looks.places[b]));
  });
}

}  // namespace

std::vector<int> look_regions(const Mesh& mesh, const FaceLooks& looks) {
  UnionFind joined(mesh.face_count());
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] >= 0 && !jump_at(mesh, looks, edge))
      joined.join(edge.faces[0], edge.faces[1]);
  }
  std::vector<int> regions;
  for (int face = 0; face < mesh.face_count(); ++face) regions.push_back(joined.find(face));
  return regions;
}

}  // namespace foldwright
