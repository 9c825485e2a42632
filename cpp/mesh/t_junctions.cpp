#include "mesh/t_junctions.h"

#include <algorithm>
#include <utility>

#include "mesh/edge_groups.h"
#include "mesh/edge_insertion.h"
#include "mesh/segment_query.h"

namespace foldwright {
namespace {

std::vector<int> border_half_edges(const TriangleSoup& soup) {
  const EdgeGroups groups = group_half_edges(soup);
  std::vector<int> border;
  for (int g = 0; g < groups.count(); ++g) {
    if (groups.group(g).size() == 1) border.push_back(groups.group(g).front());
  }
  std::sort(border.begin(), border.end());
  return border;
}

/// Vertices from the start to the end of a border edge, with all border vertices on it between.
std::vector<int> chain_along(const TriangleSoup& soup, int half_edge, const SegmentQuery& query,
                             const std::vector<int>& vertices, double tolerance) {
  const int start = start_vertex(soup, half_edge);
  const int end = end_vertex(soup, half_edge);
  const int apex = end_vertex(soup, next_half_edge(half_edge));  // of a face that is nearly flat
  const Vec3& a = soup.positions[start];
  const Vec3& b = soup.positions[end];
  const double length = (b - a).norm();
  std::vector<std::pair<double, int>> between;
  for (const int i : query.near(a, b, tolerance)) {
    const int vertex = vertices[i];
    const double along = (soup.positions[vertex] - a).dot(b - a) / length;
    // Less than this from an end would make a triangle without an area.
    const bool inside = along > 0.25 * tolerance && along < length - 0.25 * tolerance;
    if (inside && vertex != start && vertex != end && vertex != apex) {
      between.emplace_back(along, vertex);
    }
  }
  std::sort(between.begin(), between.end());
  std::vector<int> chain = {start};
  for (const auto& [along, vertex] : between) chain.push_back(vertex);
  chain.push_back(end);
  return chain;
}

using Link = std::pair<int, int>;  // two vertices, the lower first

Link link_of(int a, int b) { return std::minmax(a, b); }

/// The links that occur in more than one chain, sorted: there two borders meet.
std::vector<Link> shared_links(const std::vector<std::vector<int>>& chains) {
  std::vector<Link> links;
  for (const std::vector<int>& chain : chains) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      links.push_back(link_of(chain[i], chain[i + 1]));
    }
  }
  std::sort(links.begin(), links.end());
  std::vector<Link> shared;
  for (std::size_t i = 1; i < links.size(); ++i) {
    if (links[i] == links[i - 1]) shared.push_back(links[i]);
  }
  return shared;
}

/// Inner vertices of a chain that end one of the links.
std::vector<int> useful_vertices(const std::vector<int>& chain, const std::vector<Link>& links) {
  const auto is_shared = [&](std::size_t i) {
    return std::binary_search(links.begin(), links.end(), link_of(chain[i], chain[i + 1]));
  };
  std::vector<int> useful;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    if (is_shared(i - 1) || is_shared(i)) useful.push_back(chain[i]);
  }
  return useful;
}

}  // namespace

int close_t_junctions(TriangleSoup& soup, double tolerance) {
  const std::vector<int> border = border_half_edges(soup);
  std::vector<int> vertices;
  for (const int h : border) {
    vertices.push_back(start_vertex(soup, h));
    vertices.push_back(end_vertex(soup, h));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Vec3> points;
  for (const int vertex : vertices) points.push_back(soup.positions[vertex]);

  const SegmentQuery query(points);
  std::vector<std::vector<int>> chains;
  for (const int h : border) {
    chains.push_back(chain_along(soup, h, query, vertices, tolerance));
  }
  const std::vector<Link> links = shared_links(chains);
  EdgeInsertions insertions;
  for (std::size_t i = 0; i < border.size(); ++i) {
    std::vector<int> inserted = useful_vertices(chains[i], links);
    if (!inserted.empty()) insertions.emplace(border[i], std::move(inserted));
  }
  insert_on_edges(soup, insertions);
  return static_cast<int>(insertions.size());
}

}  // namespace foldwright
