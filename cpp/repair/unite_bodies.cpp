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

/// Sorts bodies by those that are to be united with each other.
class Clusters {
 public:
  Clusters(const TriangleSoup& soup, const BodyWork& work)
      : soup_(soup), work_(work), joined_(static_cast<int>(work.cavity_of.size())) {
    const std::vector<char>& closed = work.closed;
    std::vector<char> is_apart(closed.size(), false);
    crosses_.assign(closed.size(), false);
    for (const auto& [a, b] : work.crossings.pairs) {
      if (closed[a] && closed[b]) {
        joined_.join(solid_of(a), solid_of(b));
        crosses_[solid_of(a)] = crosses_[solid_of(b)] = true;
      } else {
        for (const int body : {a, b}) is_apart[body] = is_apart[body] || !closed[body];
      }
    }
    apart_ = static_cast<int>(std::ranges::count(is_apart, true));
  }

  /// Open bodies, which have no inside.
  int apart() const { return apart_; }

  std::vector<Cluster> all() const {
    // The solid of a body is that of the body whose hollow it is.
    std::vector<std::vector<int>> faces_of(crosses_.size());
    for (int f = 0; f < soup_.face_count(); ++f) faces_of[solid_of(work_.bodies[f])].push_back(f);
    std::vector<Cluster> clusters;
    std::vector<int> cluster_of(crosses_.size(), -1);
    for (int body = 0; body < static_cast<int>(crosses_.size()); ++body) {
      if (!crosses_[body]) continue;
      int& cluster = cluster_of[joined_.find(body)];
      if (cluster == -1) {
        cluster = static_cast<int>(clusters.size());
        clusters.emplace_back();
      }
      add(faces_of[body], clusters[cluster]);
    }
    return clusters;
  }

 private:
  int solid_of(int body) const {
    return work_.cavity_of[body] == -1 ? body : work_.cavity_of[body];
  }

  void add(const std::vector<int>& faces, Cluster& cluster) const {
    Solid solid;
    std::vector<int> vertices;
    for (const int f : faces) {
      vertices.insert(vertices.end(), soup_.faces[f].begin(), soup_.faces[f].end());
    }
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    const auto index_of = [&](int vertex) {
      return static_cast<int>(std::ranges::lower_bound(vertices, vertex) - vertices.begin());
    };
    for (const int v : vertices) solid.positions.push_back(soup_.positions[v]);
    for (const int f : faces) {
      const auto& [a, b, c] = soup_.faces[f];
      solid.faces.push_back({index_of(a), index_of(b), index_of(c)});
    }
    cluster.solids.push_back(std::move(solid));
    cluster.faces.insert(cluster.faces.end(), faces.begin(), faces.end());
  }

  const TriangleSoup& soup_;
  const BodyWork& work_;
  mutable UnionFind joined_;
  std::vector<char> crosses_;
  int apart_ = 0;
};

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
  const Clusters clusters(soup, work);
  UnitedBodies result{.apart = clusters.apart()};
  std::vector<char> keep(soup.faces.size(), true);
  for (const Cluster& cluster : clusters.all()) {
    const auto bodies = static_cast<int>(cluster.solids.size());
    const std::optional<UnitedSolids> united = unite ? unite(cluster.solids) : std::nullopt;
    if (!united) {
      result.apart += bodies;
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
