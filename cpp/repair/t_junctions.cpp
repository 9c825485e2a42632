#include "repair/t_junctions.h"

#include <algorithm>
#include <utility>

#include "repair/edge_groups.h"
#include "repair/edge_insertion.h"
#include "repair/segment_query.h"

namespace foldwright {
namespace {

double distance_to_line(const TriangleSoup& soup, int half_edge, int vertex) {
  const Vec3& a = soup.positions[start_vertex(soup, half_edge)];
  const Vec3 along = (soup.positions[end_vertex(soup, half_edge)] - a).normalized();
  return along.cross(soup.positions[vertex] - a).norm();
}

/// Vertices from the start to the end of a border edge, with all border vertices on it between.
std::vector<int> chain_along(const TriangleSoup& soup, int half_edge, const SegmentQuery& query,
                             const std::vector<int>& vertices, std::span<const double> tolerances) {
  const int start = start_vertex(soup, half_edge);
  const int end = end_vertex(soup, half_edge);
  const int apex = end_vertex(soup, next_half_edge(half_edge));  // of a face that is nearly flat
  const Vec3& a = soup.positions[start];
  const Vec3& b = soup.positions[end];
  const double length = (b - a).norm();
  const double edge_reach = std::min(tolerances[start], tolerances[end]);
  std::vector<std::pair<double, int>> between;
  for (const int i : query.near(a, b, edge_reach)) {
    const int vertex = vertices[i];
    const double along = (soup.positions[vertex] - a).dot(b - a) / length;
    const double tolerance = std::min(edge_reach, tolerances[vertex]);
    if (distance_to_line(soup, half_edge, vertex) > tolerance) continue;
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

ClosedCracks close_t_junctions(TriangleSoup& soup, std::span<const double> tolerances) {
  const std::vector<int> border = border_half_edges(soup);
  const std::vector<int> vertices = vertices_of(soup, border);
  std::vector<Vec3> points;
  for (const int vertex : vertices) points.push_back(soup.positions[vertex]);

  const SegmentQuery query(points);
  std::vector<std::vector<int>> chains;
  for (const int h : border) chains.push_back(chain_along(soup, h, query, vertices, tolerances));
  const std::vector<Link> links = shared_links(chains);
  ClosedCracks closed;
  EdgeInsertions insertions;
  soup.errors.resize(soup.positions.size(), 0);
  for (std::size_t i = 0; i < border.size(); ++i) {
    std::vector<int> inserted = useful_vertices(chains[i], links);
    if (inserted.empty()) continue;
    for (const int vertex : inserted) {
      const double off = distance_to_line(soup, border[i], vertex);
      soup.errors[vertex] = std::max(soup.errors[vertex], off);
      closed.width = std::max(closed.width, off);
    }
    insertions.emplace(border[i], std::move(inserted));
  }
  insert_on_edges(soup, insertions);
  closed.moved = closed.width;
  closed.edges = static_cast<int>(insertions.size());
  return closed;
}

ClosedCracks close_t_junctions(TriangleSoup& soup, double tolerance) {
  const std::vector<double> tolerances(soup.positions.size(), tolerance);
  return close_t_junctions(soup, tolerances);
}

}  // namespace foldwright
