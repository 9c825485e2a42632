#pragma once

#include <array>
#include <vector>

#include "unfold/layout.h"

namespace foldwright {

/// What becomes of an edge of a net, as FOLD writes it.
enum class Assignment : char { kCut = 'B', kMountain = 'M', kValley = 'V', kFlat = 'F' };

struct NetEdge {
  std::array<int, 2> vertices;  ///< of the net, counter-clockwise around the face it came from
  int mesh_edge;                ///< the two sides of a cut name the same one
  Assignment assignment;
  double angle;  ///< fold angle in radians: valley positive, mountain negative; 0 for a cut
};

/// A part laid flat, seen from the printed side. Faces that a fold joins share its two vertices;
/// where the net is cut, each side has its own.
struct Net {
  std::vector<int> faces;                   ///< of the mesh, ascending
  std::vector<Vec2> vertices;               ///< model units until laid on sheets
  std::vector<std::array<int, 3>> corners;  ///< per face: its vertices, counter-clockwise
  std::vector<NetEdge> edges;               ///< folds once, cuts once per side
};

/// The net that a fold tree of `graph` makes. Linear.
Net make_net(const Mesh& mesh, const DualGraph& graph, std::span<const int> folds);

/// What an independent look at a net found; all as it should be when `valid()`.
struct NetCheck {
  int overlaps = 0;         ///< pairs of faces that overlap
  int mirrored = 0;         ///< faces that lie with their back up
  int unconnected = 0;      ///< faces that no chain of folds joins to the first
  double length_error = 0;  ///< greatest relative difference of an edge from the mesh's
  bool valid() const {
    // Congruent to 1e-6 as the outputs promise; layout errors are a thousand times smaller.
    return overlaps == 0 && mirrored == 0 && unconnected == 0 && length_error < 1e-6;
  }
};

/// Checks a net from its coordinates alone, by other means than the search: areas of intersection
/// of all pairs that a sweep finds, edge lengths against the mesh, orientation, connectivity.
NetCheck check_net(const Mesh& mesh, const Net& net);

}  // namespace foldwright
