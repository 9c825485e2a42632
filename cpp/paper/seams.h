#pragma once

#include <array>
#include <span>
#include <vector>

#include "unfold/net.h"

namespace foldwright {

/// One side of a cut: an edge of a net, and the face it belongs to.
struct SeamSide {
  int net, edge;
  int face;       ///< index within the net
  Vec2 from, to;  ///< the edge; the face lies on its left
  Vec2 third;     ///< the face's corner off the edge

  /// A point in the coordinates of the base: x along the edge, y outwards.
  Vec2 local(const Vec2& p) const;
  /// And back.
  Vec2 global(const Vec2& p) const;
  double length() const { return (to - from).norm(); }
};

/// A cut between two faces: what is glued to what.
struct Seam {
  int mesh_edge;
  std::array<SeamSide, 2> sides;  ///< by net, then edge
};

/// The seams of nets that together make a model, by mesh edge. Borders of the model have no other
/// side, and are none. Takes n log n.
std::vector<Seam> find_seams(std::span<const Net> nets);

/// What the joints of the mesh glue together: the border edge first, then its host, which may be a
/// fold, a side of a cut, or within a flat panel. By joint; those with a side in none of the nets
/// are left out.
std::vector<Seam> find_joint_seams(const Mesh& mesh, std::span<const Net> nets);

/// The sides of open borders of the mesh, by net, then edge.
std::vector<SeamSide> find_borders(const Mesh& mesh, std::span<const Net> nets);

}  // namespace foldwright
