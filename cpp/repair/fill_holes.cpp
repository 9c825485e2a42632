#include "repair/fill_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/box_grid.h"
#include "geometry/face_contact.h"
#include "repair/border_loops.h"
#include "repair/span_loop.h"

namespace foldwright {
namespace {

using Face = std::array<int, 3>;

int shared_corners(const Face& a, const Face& b) {
  return static_cast<int>(
      std::ranges::count_if(a, [&](int v) { return std::ranges::count(b, v) > 0; }));
}

/// Lower vertex first.
using EdgeKey = std::pair<int, int>;

EdgeKey side_of(const Face& face, int i) { return std::minmax(face[i], face[(i + 1) % 3]); }

/// The faces that are there, with those that have filled holes so far.
class Surroundings {
 public:
  explicit Surroundings(const TriangleSoup& soup)
      : soup_(soup), grid_(soup.face_count(), mean_size(soup)), faces_(soup.faces) {
    Eigen::AlignedBox3d box;
    for (int f = 0; f < soup.face_count(); ++f) {
      for (const int v : faces_[f]) box.extend(soup.positions[v]);
      for (int i = 0; i < 3; ++i) edges_.push_back(side_of(faces_[f], i));
      grid_.insert(f, box_of(corners_of(faces_[f])));
    }
    extent_ = box.diagonal().norm();
    std::ranges::sort(edges_);
  }

  bool has_edge(const EdgeKey& edge) const {
    return std::ranges::binary_search(edges_, edge) || added_edges_.contains(edge);
  }

  /// Whether a face would keep clear of all others, but for the edges and vertices that it shares.
  bool has_room_for(const Face& face) const {
    const Triangle3 own = corners_of(face);
    bool is_free = true;
    grid_.visit(box_of(own), [&](int other) {
      const Triangle3 triangle = corners_of(faces_[other]);
      const int shared = shared_corners(face, faces_[other]);
      const bool cross = shared < 2 && faces_cross(own, triangle, extent_);
      return is_free = shared < 3 && !cross && !faces_overlap(own, triangle, extent_);
    });
    return is_free;
  }

  void add(const Face& face) {
    grid_.insert(static_cast<int>(faces_.size()), box_of(corners_of(face)));
    faces_.push_back(face);
    for (int i = 0; i < 3; ++i) added_edges_.insert(side_of(face, i));
  }

  /// Takes out the face that was added last.
  void take_back() {
    for (int i = 0; i < 3; ++i) added_edges_.extract(side_of(faces_.back(), i));
    grid_.remove(static_cast<int>(faces_.size()) - 1, box_of(corners_of(faces_.back())));
    faces_.pop_back();
  }

 private:
  const TriangleSoup& soup_;
  BoxGrid<3> grid_;
  double extent_ = 0;
  std::vector<Face> faces_;
  std::vector<EdgeKey> edges_;          ///< of the surface, ascending
  std::multiset<EdgeKey> added_edges_;  ///< of what fills holes

  Triangle3 corners_of(const Face& face) const {
    return {soup_.positions[face[0]], soup_.positions[face[1]], soup_.positions[face[2]]};
  }

  static double mean_size(const TriangleSoup& soup) {
    double sum = 0;
    for (const auto& [a, b, c] : soup.faces) {
      sum += box_of(Triangle3{soup.positions[a], soup.positions[b], soup.positions[c]}).diagonal();
    }
    return sum / soup.face_count();
  }
};

/// A triangle between corners of a loop whose sides 0 to 2 lead from its corners to the next ones.
using LoopTriangle = std::array<int, 3>;

/// The place in the file where a border edge's own face has one of the edge's vertices.
CornerOrigin origin_beside(const TriangleSoup& soup, int half_edge, int vertex) {
  const int face = half_edge / 3;
  const auto corner = std::ranges::find(soup.faces[face], vertex) - soup.faces[face].begin();
  return soup.origins[face][corner];
}

/// Places in the face beside a side of the triangle that lies on the border. The corner across from
/// it has that of the side's middle; a triangle without such a side has one place at all corners.
FaceOrigins origins_beside(const TriangleSoup& soup, const BorderLoop& loop,
                           const LoopTriangle& triangle) {
  const int count = static_cast<int>(loop.vertices.size());
  for (int i = 0; i < 3; ++i) {
    const int from = triangle[i];
    const int to = triangle[(i + 1) % 3];
    if ((from + 1) % count != to) continue;
    const int half_edge = loop.half_edges[from];
    FaceOrigins origins;
    origins[i] = origin_beside(soup, half_edge, loop.vertices[from]);
    origins[(i + 1) % 3] = origin_beside(soup, half_edge, loop.vertices[to]);
    origins[(i + 2) % 3] = place_between(origins[i], origins[(i + 1) % 3], 0.5);
    return origins;
  }
  const int corner = triangle[0];
  const CornerOrigin place = origin_beside(soup, loop.half_edges[corner], loop.vertices[corner]);
  return {place, place, place};
}

/// A hole, and how wide it is.
struct Hole {
  BorderLoop loop;
  double width;
};

double width_of(const TriangleSoup& soup, const BorderLoop& loop) {
  double squared = 0;
  for (const int v : loop.vertices) {
    for (const int w : loop.vertices) {
      squared = std::max(squared, (soup.positions[v] - soup.positions[w]).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

/// The holes that can be filled, the narrow ones first.
std::vector<Hole> find_holes(const TriangleSoup& soup, int& huge) {
  std::vector<Hole> holes;
  for (BorderLoop& loop : find_border_loops(soup)) {
    if (loop.vertices.size() > kMostHoleEdges) {
      ++huge;
      continue;
    }
    const double width = width_of(soup, loop);
    holes.push_back({std::move(loop), width});
  }
  std::ranges::stable_sort(holes, {}, &Hole::width);
  return holes;
}

class HoleFiller {
 public:
  HoleFiller(TriangleSoup& soup, double least_height)
      : soup_(soup), surroundings_(soup), least_height_(least_height) {}

  /// The triangles that fill a hole; none if there is no way. Later holes keep clear of them.
  std::vector<LoopTriangle> span(const BorderLoop& loop) {
    std::vector<Vec3> points;
    for (const int v : loop.vertices) points.push_back(soup_.positions[v]);
    const auto is_taken = [&](int i, int j) {
      return surroundings_.has_edge(std::minmax(loop.vertices[i], loop.vertices[j]));
    };
    std::vector<LoopTriangle> triangles =
        span_loop(points, {.least_height = least_height_, .is_taken = is_taken});
    if (!place(loop, triangles)) triangles.clear();
    return triangles;
  }

  void add(const BorderLoop& loop, const std::vector<LoopTriangle>& triangles) {
    for (const LoopTriangle& triangle : triangles) {
      if (!soup_.origins.empty()) soup_.origins.push_back(origins_beside(soup_, loop, triangle));
      soup_.faces.push_back(face_of(loop, triangle));
      soup_.source_faces.push_back(-1);
    }
  }

 private:
  TriangleSoup& soup_;
  Surroundings surroundings_;
  double least_height_;

  static Face face_of(const BorderLoop& loop, const LoopTriangle& t) {
    return {loop.vertices[t[0]], loop.vertices[t[1]], loop.vertices[t[2]]};
  }

  /// Puts triangles among the surroundings, or none of them where one has no room.
  bool place(const BorderLoop& loop, const std::vector<LoopTriangle>& triangles) {
    for (std::size_t placed = 0; placed < triangles.size(); ++placed) {
      const Face face = face_of(loop, triangles[placed]);
      if (surroundings_.has_room_for(face)) {
        surroundings_.add(face);
        continue;
      }
      for (; placed > 0; --placed) surroundings_.take_back();
      return false;
    }
    return true;
  }
};

}  // namespace

Holes fill_holes(TriangleSoup& soup, double widest, double least_height) {
  Holes holes;
  const std::vector<Hole> found = find_holes(soup, holes.huge);
  if (found.empty()) return holes;
  HoleFiller filler(soup, least_height);
  for (const auto& [loop, width] : found) {
    const std::vector<LoopTriangle> triangles = filler.span(loop);
    if (width > widest) {
      if (!triangles.empty()) holes.left.push_back(width);
    } else if (triangles.empty()) {
      ++holes.refused;
    } else {
      filler.add(loop, triangles);
      ++holes.filled;
    }
  }
  return holes;
}

}  // namespace foldwright
