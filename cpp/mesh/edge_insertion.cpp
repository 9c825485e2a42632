#include "mesh/edge_insertion.h"

namespace foldwright {
namespace {

/// Replaces the triangle at the edge from `a` to `b` by a fan from its third corner over the chain.
void insert_chain(std::vector<std::array<int, 3>>& triangles, int a, int b,
                  const std::vector<int>& chain) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (triangles[t][i] != a || triangles[t][(i + 1) % 3] != b) continue;
      const int apex = triangles[t][(i + 2) % 3];
      triangles[t] = {a, chain.front(), apex};
      for (std::size_t c = 0; c < chain.size(); ++c) {
        triangles.push_back({chain[c], c + 1 < chain.size() ? chain[c + 1] : b, apex});
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
    std::vector<std::array<int, 3>> triangles = {corners};
    for (; entry != insertions.end() && entry->first / 3 == face; ++entry) {
      const int i = entry->first % 3;
      insert_chain(triangles, corners[i], corners[(i + 1) % 3], entry->second);
    }
    soup.faces[face] = triangles.front();
    soup.faces.insert(soup.faces.end(), triangles.begin() + 1, triangles.end());
    soup.source_faces.resize(soup.faces.size(), soup.source_faces[face]);
  }
}

}  // namespace foldwright
