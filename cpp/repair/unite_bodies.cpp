#include "repair/unite_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/triangle3.h"
#include "geometry/union_find.h"
#include "repair/drop_faces.h"

namespace foldwright {
namespace {

/// Faces of some bodies, as solids for the uniter.
struct Cluster {
  std::vector<Solid> solids;
  std::vector<int> faces;  ///< of the soup, in the order in which the solids have them
};

/// The solid that a body belongs to, by its outer body: hollows belong to the body around them.
int solid_of(const BodyWork& work, int body) {
  return work.cavity_of[body] == -1 ? body : work.cavity_of[body];
}

Solid make_solid(const TriangleSoup& soup, const std::vector<int>& faces) {
  std::vector<int> vertices;
  for (const int f : faces) {
    vertices.insert(vertices.end(), soup.faces[f].begin(), soup.faces[f].end());
  }
  std::ranges::sort(vertices);
  vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
  const auto index_of = [&](int vertex) {
    return static_cast<int>(std::ranges::lower_bound(vertices, vertex) - vertices.begin());
  };
  Solid solid;
  for (const int v : vertices) solid.positions.push_back(soup.positions[v]);
  for (const int f : faces) {
    const auto& [a, b, c] = soup.faces[f];
    solid.faces.push_back({index_of(a), index_of(b), index_of(c)});
  }
  return solid;
}

/// The solids that cross, those together that do so one by one.
std::vector<Cluster> crossing_solids(const TriangleSoup& soup, const BodyWork& work) {
  const std::size_t count = work.closed.size();
  UnionFind joined(static_cast<int>(count));
  std::vector<char> crosses(count, false);
  for (const auto& [a, b] : work.crossings.pairs) {
    if (!work.closed[a] || !work.closed[b]) continue;
    joined.join(solid_of(work, a), solid_of(work, b));
    crosses[solid_of(work, a)] = crosses[solid_of(work, b)] = true;
  }
  std::vector<std::vector<int>> faces_of(count);
  for (int f = 0; f < soup.face_count(); ++f) {
    const int solid = solid_of(work, work.bodies[f]);
    if (crosses[solid]) faces_of[solid].push_back(f);
  }
  std::vector<Cluster> clusters;
  std::vector<int> cluster_of(count, -1);
  for (std::size_t body = 0; body < count; ++body) {
    if (!crosses[body]) continue;
    int& at = cluster_of[joined.find(static_cast<int>(body))];
    if (at == -1) {
      at = static_cast<int>(clusters.size());
      clusters.emplace_back();
    }
    Cluster& cluster = clusters[at];
    cluster.solids.push_back(make_solid(soup, faces_of[body]));
    cluster.faces.insert(cluster.faces.end(), faces_of[body].begin(), faces_of[body].end());
  }
  return clusters;
}

/// Number of open bodies that cross others.
int count_open(const BodyWork& work) {
  std::vector<char> is_open(work.closed.size(), false);
  for (const auto& [a, b] : work.crossings.pairs) {
    for (const int body : {a, b}) is_open[body] = !work.closed[body];
  }
  return static_cast<int>(std::ranges::count(is_open, true));
}

/// The place in the file of a point of a face.
CornerOrigin origin_at(const TriangleSoup& soup, int face, const Vec3& point) {
  const auto& corners = soup.faces[face];
  for (int i = 0; i < 3; ++i) {
    if (soup.positions[corners[i]] == point) return soup.origins[face][i];
  }
  Vec3 shares = barycentric(
      {soup.positions[corners[0]], soup.positions[corners[1]], soup.positions[corners[2]]}, point);
  // The point lies on the face up to rounding.
  shares = shares.cwiseMax(0);
  return place_within(soup.origins[face], shares / shares.sum());
}

/// Puts the united faces behind those that are there; they name faces of `cluster`.
void append(TriangleSoup& soup, const UnitedSolids& united, const std::vector<int>& cluster) {
  const auto first = static_cast<int>(soup.positions.size());
  soup.errors.resize(soup.positions.size(), 0);
  soup.positions.insert(soup.positions.end(), united.positions.begin(), united.positions.end());
  soup.errors.resize(soup.positions.size(), 0);
  for (std::size_t i = 0; i < united.faces.size(); ++i) {
    const int source = cluster[united.sources[i]];
    double error = 0;
    for (const int v : soup.faces[source]) error = std::max(error, soup.errors[v]);
    std::array<int, 3> face;
    FaceOrigins origins;
    for (int k = 0; k < 3; ++k) {
      const int v = united.faces[i][k];
      face[k] = first + v;
      soup.errors[first + v] = std::max(soup.errors[first + v], error);
      if (!soup.origins.empty()) origins[k] = origin_at(soup, source, united.positions[v]);
    }
    soup.faces.push_back(face);
    soup.source_faces.push_back(soup.source_faces[source]);
    if (!soup.origins.empty()) soup.origins.push_back(origins);
  }
}

}  // namespace

UnitedBodies unite_bodies(TriangleSoup& soup, const BodyWork& work, const SolidUniter& unite) {
  UnitedBodies result{.open = count_open(work)};
  std::vector<char> keep(soup.faces.size(), true);
  for (const Cluster& cluster : crossing_solids(soup, work)) {
    const auto bodies = static_cast<int>(cluster.solids.size());
    const std::optional<UnitedSolids> united = unite ? unite(cluster.solids) : std::nullopt;
    if (!united) {
      result.failed += bodies;
      continue;
    }
    result.united += bodies;
    for (const int f : cluster.faces) keep[f] = false;
    append(soup, *united, cluster.faces);
  }
  keep.resize(soup.faces.size(), true);
  keep_only(soup, keep);
  return result;
}

}  // namespace foldwright
