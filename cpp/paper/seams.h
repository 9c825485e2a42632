#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "paper/flap_cover.h"
#include "paper/net_panels.h"

namespace foldwright {

/// The coordinates of a seam's side: x along its edges, y outwards.
struct SeamFrame {
  Vec2 from, along;  ///< in those of the net; `along`: unit vector

  Vec2 local(const Vec2& p) const { return {along.dot(p - from), cross(p - from, along)}; }
  Vec2 global(const Vec2& p) const {
    return from + p.x() * along + p.y() * Vec2(along.y(), -along.x());
  }
};

/// One side of a seam: edges of a net that follow each other in a straight line along a panel.
struct SeamSide {
  int net;
  std::vector<int> edges;   ///< of the net, one after the other from `from` to `to`
  std::vector<int> faces;   ///< beside each of them; indices within the net
  std::array<int, 2> base;  ///< vertices of the net: where they begin and end
  Vec2 from, to;            ///< the same; the panel lies on their left
  FlapCover panel;          ///< over the base, into the panel

  int edge() const { return edges.front(); }
  SeamFrame frame() const;
  /// A point in the coordinates of the frame, and back.
  Vec2 local(const Vec2& p) const;
  Vec2 global(const Vec2& p) const;
  double length() const { return (to - from).norm(); }
};

/// What is glued in one go: cut edges that follow each other in a straight line between the same
/// two panels.
struct Seam {
  std::vector<int> mesh_edges;    ///< ascending
  std::array<SeamSide, 2> sides;  ///< by net, then first edge

  /// The one that names it.
  int mesh_edge() const { return mesh_edges.front(); }
  /// What hides a flap on a side: the panel on the other one.
  FlapCover cover_of(int side) const;
};

/// The seams of nets that together make a model, by lowest mesh edge. Borders of the model have no
/// other side, and are none. `panels`: of the nets. Takes n log n.
std::vector<Seam> find_seams(std::span<const Net> nets, std::span<const NetPanels> panels);
std::vector<Seam> find_seams(std::span<const Net> nets);

/// A seam with one of its sides.
struct SeamStep {
  int seam, side;
};

/// The sides of seams by their net and the vertex that they start from: at most one, as a net's
/// vertex stands for one fan of corners.
std::map<std::pair<int, int>, SeamStep> seam_starts(std::span<const Seam> seams);

/// Per net the sides of its seams as they come along its outlines.
std::vector<std::vector<SeamStep>> steps_along_outlines(std::span<const Net> nets,
                                                        std::span<const Seam> seams);

/// Seams that follow each other along both outlines of the same two nets, or of a net and itself:
/// what is glued in one go. Steps name the sides on one bank, in the order of its outline. Every
/// seam is in one chain; by the lowest seam.
std::vector<std::vector<SeamStep>> seam_chains(std::span<const Seam> seams);

/// What the joints of the mesh glue together: the border edge first, then its host, which may be a
/// fold, a side of a cut, or within a flat panel. By joint; those with a side in none of the nets
/// are left out.
std::vector<Seam> find_joint_seams(const Mesh& mesh, std::span<const Net> nets);

/// The sides of open borders of the mesh, straight runs along a panel as one, by net, then edge. At
/// joints every edge is one of its own.
std::vector<SeamSide> find_borders(const Mesh& mesh, std::span<const Net> nets,
                                   std::span<const NetPanels> panels);

}  // namespace foldwright
