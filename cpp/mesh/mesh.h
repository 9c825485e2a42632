#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// A border edge that lies on another edge, to which it is glued although no face of the one
/// continues the other: see `find_joints`. Indices of edges.
struct Joint {
  int edge, host;
};

/// Triangle mesh with the connectivity that unfolding needs; plain data, never edited in place.
///
/// Guaranteed by `make_mesh`: every edge has one or two faces, two faces of an edge run along it in
/// opposite directions, faces are counter-clockwise seen from the printed side (the outside).
struct Mesh {
  struct Edge {
    std::array<int, 2> vertices;  ///< in the direction of `faces[0]`
    std::array<int, 2> faces;     ///< `faces[1]` is -1 at a border
  };

  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  /// Per face: index of the face it came from in the file as read, -1 if it fills a hole.
  std::vector<int> source_faces;

  std::vector<Edge> edges;                     ///< in order of first appearance in `faces`
  std::vector<std::array<int, 3>> face_edges;  ///< [f][i]: edge from corner i to corner i + 1
  std::vector<int> components;                 ///< per face: its edge-connected component, from 0
  int component_count = 0;
  std::vector<Joint> joints;  ///< by edge; of repaired models, empty in parts of them

  int face_count() const { return static_cast<int>(faces.size()); }
  int vertex_count() const { return static_cast<int>(positions.size()); }
  int edge_count() const { return static_cast<int>(edges.size()); }
};

/// Builds edges and components from positions and faces.
/// `source_faces` may be empty: then face i comes from source face i.
/// \pre every edge has one or two faces that run along it in opposite directions
Mesh make_mesh(std::vector<Vec3> positions, std::vector<std::array<int, 3>> faces,
               std::vector<int> source_faces = {});

/// The mesh of some faces alone, in their order; `source_faces` are carried over.
Mesh submesh(const Mesh& mesh, std::span<const int> faces);

/// Area of one face, in square model units.
double face_area(const Mesh& mesh, int face);

/// Mean length over all edges, in model units: the scale that tolerances are relative to.
double mean_edge_length(const Mesh& mesh);

}  // namespace foldwright
