#include "repair/edge_groups.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace foldwright {

EdgeGroups group_half_edges(const TriangleSoup& soup) {
  std::vector<std::pair<std::uint64_t, int>> keyed;
  keyed.reserve(soup.faces.size() * 3);
  for (int h = 0; h < 3 * soup.face_count(); ++h) {
    const auto [low, high] = std::minmax({start_vertex(soup, h), end_vertex(soup, h)});
    keyed.emplace_back(static_cast<std::uint64_t>(low) << 32 | static_cast<unsigned>(high), h);
  }
  std::sort(keyed.begin(), keyed.end());
  EdgeGroups groups;
  groups.half_edges.reserve(keyed.size());
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    groups.half_edges.push_back(keyed[i].second);
    if (i + 1 == keyed.size() || keyed[i + 1].first != keyed[i].first) {
      groups.first.push_back(static_cast<int>(i) + 1);
    }
  }
  return groups;
}

std::vector<int> border_half_edges(const TriangleSoup& soup) {
  const EdgeGroups groups = group_half_edges(soup);
  std::vector<int> border;
  for (int g = 0; g < groups.count(); ++g) {
    if (groups.group(g).size() == 1) border.push_back(groups.group(g).front());
  }
  std::sort(border.begin(), border.end());
  return border;
}

std::vector<int> vertices_of(const TriangleSoup& soup, std::span<const int> half_edges) {
  std::vector<int> vertices;
  for (const int h : half_edges) {
    vertices.push_back(start_vertex(soup, h));
    vertices.push_back(end_vertex(soup, h));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace foldwright
