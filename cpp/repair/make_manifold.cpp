#include "repair/make_manifold.h"

#include <algorithm>
#include <utility>

#include "repair/edge_groups.h"
#include "repair/join_faces.h"
#include "repair/orient.h"

namespace foldwright {
namespace {

void part(Partners& partners, int half_edge) {
  partners[partners[half_edge]] = -1;
  partners[half_edge] = -1;
}

/// Has the faces that a split has added turned as the other faces of their polygons are.
void follow_sources(const TriangleSoup& triangles, std::vector<char>& turned) {
  const std::vector<int>& sources = triangles.source_faces;  // -1 for what fills a hole
  if (turned.size() == sources.size()) return;
  std::vector<char> is_turned(2 + *std::ranges::max_element(sources), false);
  for (std::size_t f = 0; f < turned.size(); ++f) is_turned[1 + sources[f]] |= turned[f];
  for (std::size_t f = turned.size(); f < sources.size(); ++f) {
    turned.push_back(is_turned[1 + sources[f]]);
  }
}

}  // namespace

ManifoldWork make_manifold(TriangleSoup& triangles) {
  ManifoldWork work;
  std::vector<char> turned(triangles.faces.size(), false);
  Partners partners = join_manifold_edges(triangles, group_half_edges(triangles));
  const Orientation patches = orient(triangles, partners, turned);
  turn_faces(triangles, partners, patches.turned);
  turned = patches.turned;

  // Only faces that know their outside can be paired; the pairs in turn may connect patches that
  // were wound by guess.
  work.nonmanifold_edges =
      join_nonmanifold_edges(triangles, group_half_edges(triangles), patches, partners);
  const Orientation whole = orient(triangles, partners, turned);
  for (const int h : whole.contradictions) part(partners, h);
  turn_faces(triangles, partners, whole.turned);
  for (std::size_t f = 0; f < turned.size(); ++f) turned[f] ^= whole.turned[f];
  work.contradictions = static_cast<int>(whole.contradictions.size());
  work.splits = split_nonmanifold(triangles, partners);
  follow_sources(triangles, turned);
  work.turned = std::move(turned);
  return work;
}

Splits restore_winding(TriangleSoup& triangles, const std::vector<char>& turned) {
  turn_faces(triangles, turned);
  Partners partners = join_manifold_edges(triangles, group_half_edges(triangles));
  for (int h = 0; h < static_cast<int>(partners.size()); ++h) {
    const int other = partners[h];
    if (other != -1 && start_vertex(triangles, h) != end_vertex(triangles, other)) {
      part(partners, h);
    }
  }
  return split_nonmanifold(triangles, partners);
}

}  // namespace foldwright
