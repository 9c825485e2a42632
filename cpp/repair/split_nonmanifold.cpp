#include "repair/split_nonmanifold.h"

#include "geometry/union_find.h"
#include "repair/edge_groups.h"
#include "repair/edge_insertion.h"

namespace foldwright {
namespace {

/// Corners that turn around the same vertex through joined edges. A corner has the number of the
/// half-edge that starts there.
UnionFind find_fans(const Partners& partners) {
  const int count = static_cast<int>(partners.size());
  UnionFind fans(count);
  for (int h = 0; h < count; ++h) {
    if (partners[h] != -1) fans.join(h, next_half_edge(partners[h]));
  }
  return fans;
}

int split_vertices(TriangleSoup& soup, const Partners& partners) {
  UnionFind fans = find_fans(partners);
  std::vector<int> fans_of(soup.positions.size(), 0);
  std::vector<int> copy_of(partners.size(), -1);  // per fan, at the corner that stands for it
  for (int corner = 0; corner < static_cast<int>(partners.size()); ++corner) {
    int& vertex = soup.faces[corner / 3][corner % 3];
    int& copy = copy_of[fans.find(corner)];
    if (copy == -1) {
      copy = vertex;
      if (++fans_of[vertex] > 1) {
        copy = add_vertex(soup, Vec3(soup.positions[vertex]), vertex);
      }
    }
    vertex = copy;
  }
  int split = 0;
  for (const int fan_count : fans_of) split += fan_count > 1;
  return split;
}

/// Halves all but the first of the edges that connect the same two vertices.
int halve_parallel_edges(TriangleSoup& soup, const Partners& partners) {
  const EdgeGroups groups = group_half_edges(soup);
  EdgeInsertions insertions;
  int count = 0;
  for (int g = 0; g < groups.count(); ++g) {
    const int first = groups.group(g).front();
    for (const int h : groups.group(g)) {
      const bool is_counted = partners[h] != -1 && partners[h] < h;
      if (h == first || partners[h] == first || is_counted) continue;
      const int start = start_vertex(soup, h);
      const int middle = add_vertex(
          soup, 0.5 * (soup.positions[start] + soup.positions[end_vertex(soup, h)]), start);
      insertions[h] = {middle};
      if (partners[h] != -1) insertions[partners[h]] = {middle};
      ++count;
    }
  }
  insert_on_edges(soup, insertions);
  return count;
}

}  // namespace

Splits split_nonmanifold(TriangleSoup& soup, const Partners& partners) {
  Splits splits;
  splits.vertices = split_vertices(soup, partners);
  splits.midpoints = halve_parallel_edges(soup, partners);
  return splits;
}

}  // namespace foldwright
