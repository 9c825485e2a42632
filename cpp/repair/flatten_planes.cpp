#include "repair/flatten_planes.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "geometry/union_find.h"
#include "mesh/dual_graph.h"
#include "repair/planar_fit.h"

namespace foldwright {
namespace {

// Planes off by less of their extent are exact: edges between two of them lie on one line.
constexpr double kExact = 1e-9;

// What is left after a solution, in shares of a plane's extent: far below what tells panels apart.
constexpr double kSolved = 1e-11;

// A vertex that has to move by so many times what the planes are off lies in planes that contradict
// each other. Three planes that meet at acute angles need several times.
constexpr double kFurthest = 10;

/// A plane to be made flat.
struct Plane {
  std::vector<int> faces;
  std::vector<int> vertices;  ///< ascending
  double off = 0;             ///< how far its vertices were off it, or may have been
};

std::vector<int> vertices_of(const TriangleSoup& soup, std::span<const int> faces) {
  std::vector<int> vertices;
  for (const int face : faces) {
    vertices.insert(vertices.end(), soup.faces[face].begin(), soup.faces[face].end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// The equations of planes that share vertices, and their solution step by step.
class PlaneSystem {
 public:
  PlaneSystem(TriangleSoup& soup, std::span<const Plane> planes) : soup_(soup), planes_(planes) {
    for (const Plane& plane : planes) {
      vertices_.insert(vertices_.end(), plane.vertices.begin(), plane.vertices.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  /// Moves the vertices until the planes are flat, or do not become flatter.
  void solve() {
    constexpr int kMostSteps = 12;  // three to five are enough where the planes agree
    for (int step = 0; step < kMostSteps && !is_flat(); ++step) {
      if (!move_vertices()) return;
    }
  }

 private:
  // Weight of staying in place against lying in the planes. Each step leaves about this share of
  // what a plane is off; much less would cost digits of the factorization.
  static constexpr double kStay = 1e-5;

  TriangleSoup& soup_;
  std::span<const Plane> planes_;
  std::vector<int> vertices_;  // ascending; unknowns 3 i .. 3 i + 2 move the i-th

  bool is_flat() const {
    return std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      const PlanarFit fit = fit_plane(soup_, plane.faces);
      return fit.deviation <= kSolved * fit.extent;
    });
  }

  int unknown_of(int vertex) const {
    const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
    return 3 * static_cast<int>(place - vertices_.begin());
  }

  /// One row per plane and vertex: height of the vertex, moved, over the plane, tilted and lifted.
  void add_rows(const Plane& plane, int unknown, std::vector<Eigen::Triplet<double>>& entries,
                std::vector<double>& heights) const {
    const PlanarFit fit = fit_plane(soup_, plane.faces);
    const Vec3 x = fit.normal.unitOrthogonal();
    const Vec3 y = fit.normal.cross(x);
    for (const int v : plane.vertices) {
      const int row = static_cast<int>(heights.size());
      const Vec3 arm = soup_.positions[v] - fit.centre;
      for (int i = 0; i < 3; ++i) entries.emplace_back(row, unknown_of(v) + i, fit.normal[i]);
      entries.emplace_back(row, unknown, -1);
      entries.emplace_back(row, unknown + 1, -2 * arm.dot(x) / fit.extent);
      entries.emplace_back(row, unknown + 2, -2 * arm.dot(y) / fit.extent);
      heights.push_back(arm.dot(fit.normal));
    }
  }

  bool move_vertices() {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> heights;
    int unknowns = 3 * static_cast<int>(vertices_.size());
    for (const Plane& plane : planes_) {
      add_rows(plane, unknowns, entries, heights);
      unknowns += 3;
    }
    Eigen::SparseMatrix<double> rows(static_cast<int>(heights.size()), unknowns);
    rows.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> stay(unknowns, unknowns);
    stay.setIdentity();
    const Eigen::SparseMatrix<double> normal_matrix = rows.transpose() * rows + kStay * stay;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(normal_matrix);
    if (factors.info() != Eigen::Success) return false;
    const Eigen::Map<const Eigen::VectorXd> off(heights.data(), rows.rows());
    const Eigen::VectorXd moves = factors.solve(-(rows.transpose() * off));
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      soup_.positions[vertices_[i]] += moves.segment<3>(3 * static_cast<int>(i));
    }
    return true;
  }
};

/// Whether a plane's faces make one panel by their angles with the largest of them.
bool is_panel(const TriangleSoup& soup, std::span<const int> faces) {
  Vec3 largest = Vec3::Zero();
  for (const int face : faces) {
    const Vec3 normal = area_vector(soup, face);
    if (normal.squaredNorm() > largest.squaredNorm()) largest = normal;
  }
  return std::all_of(faces.begin(), faces.end(), [&](int face) {
    const Vec3 normal = area_vector(soup, face);
    return std::atan2(normal.cross(largest).norm(), normal.dot(largest)) < kPanelAngle;
  });
}

/// The planes in clusters that share vertices; those with all of their planes exact are left out.
std::vector<std::vector<Plane>> inexact_clusters(const TriangleSoup& soup,
                                                 const DrawnPlanes& planes) {
  UnionFind clusters(static_cast<int>(planes.size()));
  std::vector<int> first_plane(soup.positions.size(), -1);
  std::vector<Plane> all;
  std::vector<char> inexact(planes.size(), false);
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    const PlanarFit fit = fit_plane(soup, planes[p]);
    Plane plane{planes[p], vertices_of(soup, planes[p]), fit.deviation};
    inexact[p] = fit.deviation > kExact * fit.extent;
    for (const int v : plane.vertices) {
      plane.off = std::max(plane.off, soup.error(v));
      if (first_plane[v] == -1) first_plane[v] = p;
      clusters.join(p, first_plane[v]);
    }
    all.push_back(std::move(plane));
  }
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    if (inexact[p]) inexact[clusters.find(p)] = true;
  }
  std::vector<std::vector<Plane>> found(planes.size());
  for (int p = 0; p < static_cast<int>(planes.size()); ++p) {
    const int leader = clusters.find(p);
    if (inexact[leader]) found[leader].push_back(std::move(all[p]));
  }
  std::erase_if(found, [](const std::vector<Plane>& cluster) { return cluster.empty(); });
  return found;
}

/// A cluster of planes that is to be solved without contradictions.
class ClusterFlattener {
 public:
  ClusterFlattener(TriangleSoup& soup, std::vector<Plane> planes)
      : soup_(soup), planes_(std::move(planes)) {
    for (const Plane& plane : planes_) {
      furthest_ = std::max(furthest_, kFurthest * plane.off);
      for (const int v : plane.vertices) before_.emplace_back(v, soup.positions[v]);
      if (is_panel(soup, plane.faces)) panels_.push_back(plane.faces);
    }
  }

  /// Solves the planes, giving up those that contradict others: the ones furthest off first, since
  /// exact ones are meant as they are. Returns those that are flat now; none if nothing was moved.
  std::vector<Plane> flatten() {
    constexpr int kMostRounds = 12;  // beyond, the planes contradict each other everywhere
    for (int round = 0; round < kMostRounds && !planes_.empty(); ++round) {
      PlaneSystem(soup_, planes_).solve();
      if (come_out()) return std::move(planes_);
      go_back();
      give_up_worst();
    }
    return {};
  }

 private:
  TriangleSoup& soup_;
  std::vector<Plane> planes_;
  double furthest_ = 0;  // that a vertex may move
  std::vector<std::pair<int, Vec3>> before_;
  std::vector<std::vector<int>> panels_;  // faces that already were panels, and have to stay so

  void go_back() {
    for (const auto& [v, position] : before_) soup_.positions[v] = position;
  }

  bool come_out() const {
    const bool near = std::all_of(before_.begin(), before_.end(), [&](const auto& place) {
      return (soup_.positions[place.first] - place.second).norm() <= furthest_;
    });
    const bool flat = std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      const PlanarFit fit = fit_plane(soup_, plane.faces);
      return fit.upright && fit.deviation <= kExact * fit.extent;
    });
    return near && flat && std::all_of(panels_.begin(), panels_.end(), [&](const auto& faces) {
             return is_panel(soup_, faces);
           });
  }

  void give_up_worst() {
    constexpr double kAsFar = 0.5;
    double furthest_off = 0;
    for (const Plane& plane : planes_) furthest_off = std::max(furthest_off, plane.off);
    std::erase_if(planes_, [&](const Plane& plane) { return plane.off > kAsFar * furthest_off; });
  }
};

}  // namespace

Flattening flatten_planes(TriangleSoup& soup, const DrawnPlanes& planes) {
  const std::vector<Vec3> before = soup.positions;
  Flattening flattening;
  for (std::vector<Plane>& cluster : inexact_clusters(soup, planes)) {
    std::vector<Plane> bent;
    std::copy_if(cluster.begin(), cluster.end(), std::back_inserter(bent),
                 [&](const Plane& plane) { return !is_panel(soup, plane.faces); });
    cluster = ClusterFlattener(soup, std::move(cluster)).flatten();
    for (const Plane& plane : bent) {
      if (!is_panel(soup, plane.faces)) continue;  // given up
      flattening.faces.insert(flattening.faces.end(), plane.faces.begin(), plane.faces.end());
    }
    for (const Plane& plane : cluster) {
      for (const int v : plane.vertices) {
        flattening.distance = std::max(flattening.distance, (soup.positions[v] - before[v]).norm());
      }
    }
  }
  std::sort(flattening.faces.begin(), flattening.faces.end());
  return flattening;
}

}  // namespace foldwright
