#include "mesh/merge_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/union_find.h"
#include "mesh/drop_faces.h"
#include "mesh/edge_groups.h"

namespace foldwright {
namespace {

/// Two triangles that share an edge, as one quad.
struct Quad {
  std::array<int, 4> corners;   // ascending
  std::array<int, 2> diagonal;  // ascending
  std::array<int, 2> faces;     // ascending

  auto key() const { return std::tie(corners, diagonal, faces); }
};

/// All pairs of faces that run along an edge in opposite directions, by their corners.
std::vector<Quad> find_quads(const TriangleSoup& soup, const EdgeGroups& groups) {
  // Edges with more faces than this are no diagonals of quads given twice or from both sides.
  constexpr std::size_t kMostFaces = 8;
  std::vector<Quad> quads;
  for (int g = 0; g < groups.count(); ++g) {
    const auto group = groups.group(g);
    if (group.size() > kMostFaces) continue;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = i + 1; j < group.size(); ++j) {
        const auto [a, b] = std::pair(start_vertex(soup, group[i]), end_vertex(soup, group[i]));
        const int c = end_vertex(soup, next_half_edge(group[i]));
        const int d = end_vertex(soup, next_half_edge(group[j]));
        if (start_vertex(soup, group[j]) != b || c == d) continue;
        Quad quad{{a, b, c, d}, {std::min(a, b), std::max(a, b)}, {group[i] / 3, group[j] / 3}};
        std::sort(quad.corners.begin(), quad.corners.end());
        quads.push_back(quad);
      }
    }
  }
  std::sort(quads.begin(), quads.end(),
            [](const Quad& q, const Quad& r) { return q.key() < r.key(); });
  return quads;
}

Vec3 area_vector(const TriangleSoup& soup, const Quad& quad) {
  return area_vector(soup, quad.faces[0]) + area_vector(soup, quad.faces[1]);
}

/// Whether two quads with the same corners and different diagonals cover the same of one plane.
bool coincide(const TriangleSoup& soup, const Quad& q, const Quad& r, double tolerance) {
  const Vec3 area = area_vector(soup, q);
  const Vec3 normal = area.normalized();
  const Vec3& origin = soup.positions[q.corners[0]];
  const bool in_plane = std::all_of(q.corners.begin(), q.corners.end(), [&](int v) {
    return std::abs(normal.dot(soup.positions[v] - origin)) <= tolerance;
  });
  // The triangles of either lie side by side: neither diagonal leaves the quad.
  constexpr double kRounding = 1e-6;
  const auto spread = [&](const Quad& quad) {
    return area_vector(soup, quad.faces[0]).norm() + area_vector(soup, quad.faces[1]).norm();
  };
  const double whole = area.norm();
  return in_plane && std::abs(area_vector(soup, r).norm() - whole) <= kRounding * whole &&
         spread(q) <= (1 + kRounding) * whole && spread(r) <= (1 + kRounding) * whole;
}

/// What stands for what: the faces of one side, and those of the other.
struct Twins {
  std::vector<int> first;
  std::vector<int> second;  ///< the later ones in the file
};

/// Pairs of triangles with the same corners in opposite winding.
void find_opposite_triangles(const TriangleSoup& soup, std::vector<Twins>& twins) {
  std::vector<std::pair<std::array<int, 3>, int>> sorted;
  for (int f = 0; f < soup.face_count(); ++f) {
    std::array<int, 3> corners = soup.faces[f];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, f);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    twins.push_back({{sorted[i - 1].second}, {sorted[i].second}});
  }
}

/// Quads that coincide by different diagonals: with the same side up and the opposite one.
void find_other_diagonals(const TriangleSoup& soup, double tolerance, std::vector<Twins>& same,
                          std::vector<Twins>& opposite) {
  const std::vector<Quad> quads = find_quads(soup, group_half_edges(soup));
  for (std::size_t i = 0; i < quads.size(); ++i) {
    for (std::size_t j = i + 1; j < quads.size() && quads[j].corners == quads[i].corners; ++j) {
      if (quads[i].diagonal == quads[j].diagonal) continue;
      if (!coincide(soup, quads[i], quads[j], tolerance)) continue;
      const bool swapped = quads[j].faces < quads[i].faces;
      const auto& first = quads[swapped ? j : i].faces;
      const auto& second = quads[swapped ? i : j].faces;
      const bool agree = area_vector(soup, quads[i]).dot(area_vector(soup, quads[j])) > 0;
      (agree ? same : opposite)
          .push_back({{first.begin(), first.end()}, {second.begin(), second.end()}});
    }
  }
}

/// Sets of connected faces that are given from both sides.
class Sheets {
 public:
  Sheets(const TriangleSoup& soup, const std::vector<Twins>& twins)
      : sheets_(soup.face_count()), doubled_(soup.faces.size(), false) {
    for (const Twins& twin : twins) {
      for (const auto* side : {&twin.first, &twin.second}) {
        for (const int face : *side) {
          doubled_[face] = true;
          sheets_.join(face, twin.first[0]);
        }
      }
    }
    connect_and_judge(group_half_edges(soup));
  }

  /// Whether a face belongs to a wall between rooms, both of whose sides are needed.
  bool is_wall(int face) { return has_border_[sheets_.find(face)] && !ends_[sheets_.find(face)]; }

 private:
  UnionFind sheets_;
  std::vector<char> doubled_;
  std::vector<char> has_border_;  // per leading face: other faces go on somewhere
  std::vector<char> ends_;        // ... fewer than two go on somewhere at the border

  void connect_and_judge(const EdgeGroups& groups) {
    for (int g = 0; g < groups.count(); ++g) {
      int last = -1;
      for (const int h : groups.group(g)) {
        if (!doubled_[h / 3]) continue;
        if (last != -1) sheets_.join(last, h / 3);
        last = h / 3;
      }
    }
    has_border_.assign(doubled_.size(), false);
    ends_.assign(doubled_.size(), false);
    for (int g = 0; g < groups.count(); ++g) judge(groups.group(g));
  }

  void judge(std::span<const int> edge) {
    int others = 0;
    int doubled = -1;
    for (const int h : edge) {
      if (doubled_[h / 3]) doubled = h / 3;
      others += !doubled_[h / 3];
    }
    if (doubled == -1) return;
    const int sheet = sheets_.find(doubled);
    const bool both_sides_only = edge.size() == 2 && others == 0;
    if (others > 0) has_border_[sheet] = true;
    if (others == 1 || both_sides_only) ends_[sheet] = true;
  }
};

void drop(TriangleSoup& soup, std::vector<char>& keep, const std::vector<int>& faces,
          std::vector<int>& sources) {
  for (const int face : faces) {
    if (!keep[face]) continue;
    keep[face] = false;
    sources.push_back(soup.source_faces[face]);
  }
}

bool all_kept(const std::vector<char>& keep, const std::vector<int>& faces) {
  return std::all_of(faces.begin(), faces.end(), [&](int face) { return keep[face]; });
}

}  // namespace

MergedSides merge_sides(TriangleSoup& soup, double tolerance) {
  std::vector<Twins> same;
  std::vector<Twins> opposite;
  find_other_diagonals(soup, tolerance, same, opposite);
  find_opposite_triangles(soup, opposite);
  MergedSides merged;
  if (same.empty() && opposite.empty()) return merged;
  std::vector<char> keep(soup.faces.size(), true);
  for (const Twins& twin : same) {
    if (all_kept(keep, twin.first)) drop(soup, keep, twin.second, merged.repeated);
  }
  Sheets sheets(soup, opposite);
  for (const Twins& twin : opposite) {
    if (sheets.is_wall(twin.first[0]) || !all_kept(keep, twin.first)) continue;
    drop(soup, keep, twin.second, merged.two_sided);
  }
  keep_only(soup, keep);
  return merged;
}

}  // namespace foldwright
