#pragma once

#include <span>
#include <vector>

#include "unfold/net.h"

namespace foldwright {

/// The flat panels of a net: its faces as far as no fold divides them, and their borders.
class NetPanels {
 public:
  /// An edge of a panel's border, as an edge of the net; the panel lies on its left.
  struct Border {
    int from, to;  ///< vertices of the net
  };

  /// Linear in the faces, where none of many share a vertex.
  explicit NetPanels(const Net& net);

  int panel_count() const { return static_cast<int>(borders_.size()); }
  int panel_of(int face) const { return panel_of_[face]; }
  std::span<const Border> borders(int panel) const { return borders_[panel]; }

  /// The face on the left of an edge of the net, in its own direction.
  int face_at(int edge) const { return face_of_edge_[edge]; }

 private:
  std::vector<int> panel_of_;      ///< per face
  std::vector<int> face_of_edge_;  ///< per edge
  std::vector<std::vector<Border>> borders_;
};

/// Those of several nets.
std::vector<NetPanels> panels_of(std::span<const Net> nets);

}  // namespace foldwright
