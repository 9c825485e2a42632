#pragma once

#include <span>
#include <vector>

#include "repair/triangle_soup.h"

namespace foldwright {

/// The half-edges of triangles, grouped by the two vertices they connect in either direction.
struct EdgeGroups {
  std::vector<int> half_edges;
  std::vector<int> first = {0};  ///< one more entry than groups

  int count() const { return static_cast<int>(first.size()) - 1; }
  /// Half-edges of a group, ascending.
  std::span<const int> group(int g) const {
    return std::span(half_edges).subspan(first[g], first[g + 1] - first[g]);
  }
};

/// Groups are in ascending order of their lower, then their higher vertex.
EdgeGroups group_half_edges(const TriangleSoup& soup);

/// The half-edges whose edge has no other face, ascending.
std::vector<int> border_half_edges(const TriangleSoup& soup);

/// The vertices at the ends of some half-edges, ascending.
std::vector<int> vertices_of(const TriangleSoup& soup, std::span<const int> half_edges);

}  // namespace foldwright
