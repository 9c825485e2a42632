#include "repair/flat_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "geometry/union_find.h"

namespace foldwright {
namespace {

/// Whether the faces of two half-edges of one edge lie in one plane, whichever side is up: that of
/// the larger one, which is known best.
bool in_one_plane(const TriangleSoup& soup, int g, int h, double tolerance) {
  const Vec3 a = area_vector(soup, g / 3);
  const Vec3 b = area_vector(soup, h / 3);
  const bool first_is_larger = a.squaredNorm() >= b.squaredNorm();
  const Vec3 normal = (first_is_larger ? a : b).normalized();
  const int apex = end_vertex(soup, next_half_edge(first_is_larger ? h : g));
  const Vec3& origin = soup.positions[start_vertex(soup, g)];
  return std::abs(normal.dot(soup.positions[apex] - origin)) <= tolerance;
}

/// Grows layers over edges, and keeps where they end.
class LayerBuilder {
 public:
  LayerBuilder(const TriangleSoup& soup, const EdgeGroups& groups, double tolerance,
               LayerExtent extent)
      : soup_(soup),
        groups_(groups),
        tolerance_(tolerance),
        extent_(extent),
        layers_(soup.face_count()),
        is_inside_(3 * soup.faces.size(), false),
        is_alone_(3 * soup.faces.size(), false) {
    for (int g = 0; g < groups.count(); ++g) look_at(groups.group(g));
  }

  std::vector<FlatLayer> layers() {
    std::vector<char> ends_alone(soup_.faces.size(), false);  // per leading face
    for (std::size_t h = 0; h < is_alone_.size(); ++h) {
      if (is_alone_[h]) ends_alone[layers_.find(static_cast<int>(h / 3))] = true;
    }
    std::vector<FlatLayer> found;
    std::vector<int> index(soup_.faces.size(), -1);  // per leading face
    for (int f = 0; f < soup_.face_count(); ++f) {
      const int leader = layers_.find(f);
      if (ends_alone[leader]) continue;
      if (leader == f) {
        index[f] = static_cast<int>(found.size());
        found.emplace_back();
      }
      found[index[leader]].faces.push_back(f);
    }
    for (int g = 0; g < groups_.count(); ++g) {
      for (const int h : groups_.group(g)) {
        const int layer = index[layers_.find(h / 3)];
        if (layer != -1 && !is_inside_[h]) found[layer].border.push_back(g);
      }
    }
    std::sort(found.begin(), found.end(), [](const FlatLayer& a, const FlatLayer& b) {
      return std::tie(a.border, a.faces) < std::tie(b.border, b.faces);
    });
    return found;
  }

 private:
  const TriangleSoup& soup_;
  const EdgeGroups& groups_;
  double tolerance_;
  LayerExtent extent_;
  UnionFind layers_;
  std::vector<char> is_inside_;  // per half-edge: its layer goes on
  std::vector<char> is_alone_;   // per half-edge: there is no other face in its plane

  void look_at(std::span<const int> edge) {
    // Edges with more faces than this are within no polygon that was given twice: all end there.
    constexpr std::size_t kMostFaces = 16;
    if (edge.size() > kMostFaces) return;
    std::vector<int> rest(edge.begin(), edge.end());
    while (!rest.empty()) {
      const auto others = std::stable_partition(rest.begin() + 1, rest.end(), [&](int h) {
        return in_one_plane(soup_, rest.front(), h, tolerance_);
      });
      go_on(std::span(rest.begin(), others));
      rest.erase(rest.begin(), others);
    }
  }

  /// Joins the faces at an edge that lie in one plane.
  void go_on(std::span<const int> plane) {
    if (plane.size() == 1) is_alone_[plane.front()] = true;
    if (plane.size() > 2 && extent_ == LayerExtent::kToSharedEdges) return;
    const Vec3 up = area_vector(soup_, plane.front() / 3);
    std::array<std::array<std::vector<int>, 2>, 2> kinds;  // by the side up, then by direction
    for (const int h : plane) {
      const bool is_turned = area_vector(soup_, h / 3).dot(up) < 0;
      const bool is_reverse = start_vertex(soup_, h) != start_vertex(soup_, plane.front());
      kinds[is_turned][is_reverse].push_back(h);
    }
    for (const auto& [one_way, other_way] : kinds) {
      if (one_way.size() != other_way.size()) return;
    }
    for (const auto& [one_way, other_way] : kinds) {
      for (std::size_t i = 0; i < one_way.size(); ++i) {
        layers_.join(one_way[i] / 3, other_way[i] / 3);
        is_inside_[one_way[i]] = is_inside_[other_way[i]] = true;
      }
    }
  }
};

double sum_of_areas(const TriangleSoup& soup, const FlatLayer& layer) {
  double sum = 0;
  for (const int f : layer.faces) sum += area_vector(soup, f).norm();
  return sum;
}

}  // namespace

std::vector<FlatLayer> find_flat_layers(const TriangleSoup& soup, const EdgeGroups& groups,
                                        double tolerance, LayerExtent extent) {
  return LayerBuilder(soup, groups, tolerance, extent).layers();
}

bool coincide(const TriangleSoup& soup, const FlatLayer& a, const FlatLayer& b, double tolerance) {
  if (a.border.empty() || a.border != b.border) return false;
  const Vec3 area = area_vector(soup, a);
  const Vec3 normal = area.normalized();
  const Vec3& origin = soup.positions[soup.faces[a.faces[0]][0]];
  const auto is_in_plane = [&](int face) {
    return std::ranges::all_of(soup.faces[face], [&](int v) {
      return std::abs(normal.dot(soup.positions[v] - origin)) <= tolerance;
    });
  };
  // The faces of either lie side by side: none is folded back over others.
  constexpr double kRounding = 1e-6;
  const double whole = area.norm();
  return std::ranges::all_of(a.faces, is_in_plane) && std::ranges::all_of(b.faces, is_in_plane) &&
         std::abs(area_vector(soup, b).norm() - whole) <= kRounding * whole &&
         sum_of_areas(soup, a) <= (1 + kRounding) * whole &&
         sum_of_areas(soup, b) <= (1 + kRounding) * whole;
}

Vec3 area_vector(const TriangleSoup& soup, const FlatLayer& layer) {
  Vec3 sum = Vec3::Zero();
  for (const int f : layer.faces) sum += area_vector(soup, f);
  return sum;
}

}  // namespace foldwright
