#pragma once

#include <utility>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/triangle3.h"
#include "mesh/mesh.h"

namespace foldwright {

/// The faces of a mesh, to be looked for by their distance from a point.
class SurfaceTree {
 public:
  /// n log n.
  explicit SurfaceTree(const Mesh& mesh);

  const Triangle3& corners(int face) const { return corners_[face]; }
  const Vec3& normal(int face) const { return normals_[face]; }  ///< of length 1

  /// Square of the distance of a face from a point.
  double squared_distance(int face, const Vec3& point) const {
    return (closest_point(corners_[face], point) - point).squaredNorm();
  }

  /// See `BoxTree::visit_near`; visits faces.
  template <class Visit>
  void visit_near(const Vec3& point, double within, Visit&& visit) const {
    tree_.visit_near(point, within, std::forward<Visit>(visit));
  }

  /// The face nearest to a point, any of equally near ones. `guess`: a face that may be near.
  int nearest(const Vec3& point, int guess = 0) const;

 private:
  std::vector<Triangle3> corners_;
  std::vector<Vec3> normals_;
  BoxTree tree_;
};

/// The corners of a face in space.
Triangle3 corners_of(const Mesh& mesh, int face);

/// Direction out of a triangle, of length 1.
Vec3 normal_of(const Triangle3& t);

}  // namespace foldwright
