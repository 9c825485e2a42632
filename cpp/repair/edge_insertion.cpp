#include "repair/edge_insertion.h"

#include <algorithm>

namespace foldwright {
namespace {

/// A corner of a face that is being cut.
struct Corner {
  int vertex;
  CornerOrigin origin;
};
using Triangle = std::array<Corner, 3>;

Triangle triangle_of(const TriangleSoup& soup, int face) {
  Triangle triangle;
  for (int i = 0; i < 3; ++i) triangle[i].vertex = soup.faces[face][i];
  if (soup.origins.empty()) return triangle;
  for (int i = 0; i < 3; ++i) triangle[i].origin = soup.origins[face][i];
  return triangle;
}

void put_triangle(TriangleSoup& soup, int face, const Triangle& triangle) {
  for (int i = 0; i < 3; ++i) soup.faces[face][i] = triangle[i].vertex;
  if (soup.origins.empty()) return;
  for (int i = 0; i < 3; ++i) soup.origins[face][i] = triangle[i].origin;
}

/// Vertices on the edge from `a` to `b` as corners of the face there: the place of each is where it
/// falls on the edge.
std::vector<Corner> corners_on_edge(const TriangleSoup& soup, const Corner& a, const Corner& b,
                                    const std::vector<int>& vertices) {
  const Vec3& start = soup.positions[a.vertex];
  const Vec3 along = soup.positions[b.vertex] - start;
  std::vector<Corner> corners;
  for (const int vertex : vertices) {
    const double share = along.dot(soup.positions[vertex] - start) / along.squaredNorm();
    corners.push_back({vertex, soup.origins.empty() ? CornerOrigin{}
                                                    : place_between(a.origin, b.origin,
                                                                    std::clamp(share, 0.0, 1.0))});
  }
  return corners;
}

/// Replaces the triangle at the edge from `a` to `b` by a fan from its third corner over the
/// vertices.
void insert_chain(const TriangleSoup& soup, std::vector<Triangle>& triangles, int a, int b,
                  const std::vector<int>& vertices) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Corner start = triangles[t][i];
      const Corner end = triangles[t][(i + 1) % 3];
      if (start.vertex != a || end.vertex != b) continue;
      const Corner apex = triangles[t][(i + 2) % 3];
      const std::vector<Corner> chain = corners_on_edge(soup, start, end, vertices);
      triangles[t] = {start, chain.front(), apex};
      for (std::size_t c = 0; c < chain.size(); ++c) {
        triangles.push_back({chain[c], c + 1 < chain.size() ? chain[c + 1] : end, apex});
      }
      return;
    }
  }
}

}  // namespace

void insert_on_edges(TriangleSoup& soup, const EdgeInsertions& insertions) {
  for (auto entry = insertions.begin(); entry != insertions.end();) {
    const int face = entry->first / 3;
    const std::array<int, 3> corners = soup.faces[face];
    std::vector<Triangle> triangles = {triangle_of(soup, face)};
    for (; entry != insertions.end() && entry->first / 3 == face; ++entry) {
      const int i = entry->first % 3;
      insert_chain(soup, triangles, corners[i], corners[(i + 1) % 3], entry->second);
    }
    const int first_new = soup.face_count();
    const std::size_t count = soup.faces.size() + triangles.size() - 1;
    soup.faces.resize(count);
    soup.source_faces.resize(count, soup.source_faces[face]);
    if (!soup.origins.empty()) soup.origins.resize(count);
    put_triangle(soup, face, triangles.front());
    for (std::size_t t = 1; t < triangles.size(); ++t) {
      put_triangle(soup, first_new + static_cast<int>(t) - 1, triangles[t]);
    }
  }
}

}  // namespace foldwright
