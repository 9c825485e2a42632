#pragma once

#include <array>
#include <vector>

#include "geometry/vec.h"
#include "mesh/corner_origin.h"

namespace foldwright {

/// Triangles on their way through the repair: like Mesh, but nothing is guaranteed yet beyond
/// three different vertices per face. Lengths are scaled so that the model is about 1 across.
struct TriangleSoup {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  /// Per face: index of the face it came from in the file as read, -1 if it fills a hole.
  std::vector<int> source_faces;
  /// Per vertex: how far each of its coordinates may be from what was meant. Vertices past its end
  /// are exact.
  std::vector<double> errors = {};
  /// Per face: the places in the file that its corners come from, all of them means of the same
  /// three corners of its source face. Empty for triangles that come from no file.
  std::vector<FaceOrigins> origins = {};

  int face_count() const { return static_cast<int>(faces.size()); }
  double error(int vertex) const {
    return vertex < static_cast<int>(errors.size()) ? errors[vertex] : 0;
  }
};

/// Adds a vertex that is as precise as another one, and returns its index.
inline int add_vertex(TriangleSoup& soup, const Vec3& position, int like) {
  const double error = soup.error(like);
  soup.errors.resize(soup.positions.size(), 0);
  soup.errors.push_back(error);
  soup.positions.push_back(Vec3(position));
  return static_cast<int>(soup.positions.size()) - 1;
}

/// Twice the area of a face as a vector along its normal.
inline Vec3 area_vector(const TriangleSoup& soup, int face) {
  const auto& [a, b, c] = soup.faces[face];
  return (soup.positions[b] - soup.positions[a]).cross(soup.positions[c] - soup.positions[a]);
}

/// Half-edge 3 f + i runs along face f from its corner i to its corner i + 1.
inline int next_half_edge(int half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

inline int start_vertex(const TriangleSoup& soup, int half_edge) {
  return soup.faces[half_edge / 3][half_edge % 3];
}

inline int end_vertex(const TriangleSoup& soup, int half_edge) {
  return start_vertex(soup, next_half_edge(half_edge));
}

}  // namespace foldwright
