#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/box_grid.h"
#include "geometry/triangle3.h"

namespace foldwright {

/// A face by its vertices, in the order of the corners of its triangle.
using FaceVertices = std::array<int, 3>;

/// The faces of a surface that changes, and whether others would run through them.
class CrossingGuard {
 public:
  /// `faces`: how many may be held; `usual_edge`: about the length of their edges; `extent`: the
  /// diagonal of the surface's box.
  CrossingGuard(int faces, double usual_edge, double extent);

  /// Holds a face, in place of what it was before. `face`: from 0 to below the number of faces.
  void set(int face, const FaceVertices& vertices, const Triangle3& corners);
  /// \pre it is held
  void remove(int face);

  const Triangle3& corners(int face) const { return held_[face].corners; }

  /// How many of the held faces a face would run through by more than a touch (`faces_cross`), but
  /// for the `left_out` ones and those that share an edge with it.
  int crossings(const FaceVertices& vertices, const Triangle3& corners,
                std::span<const int> left_out);

 private:
  struct Held {
    FaceVertices vertices;
    Triangle3 corners;
    bool is_held = false;
  };

  BoxGrid<3> grid_;
  double extent_;
  std::vector<Held> held_;
  std::vector<int> seen_;  ///< per face: the last query that met it
  int query_ = 0;
};

}  // namespace foldwright
