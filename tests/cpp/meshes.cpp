#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

using Face = std::array<int, 3>;

/// Incremental hull: a point replaces the faces that it sees by a fan over their silhouette.
std::vector<Face> convex_hull(const std::vector<Vec3>& points) {
  const auto sees = [&](const Face& face, const Vec3& point) {
    const Vec3& a = points[face[0]];
    return (points[face[1]] - a).cross(points[face[2]] - a).dot(point - a) > 0;
  };
  std::vector<Face> hull = {{0, 1, 2}, {0, 2, 1}};
  for (int p = 3; p < static_cast<int>(points.size()); ++p) {
    std::vector<Face> kept;
    std::set<std::pair<int, int>> silhouette;  // directed edges of the faces seen, less inner ones
    for (const Face& face : hull) {
      if (!sees(face, points[p])) {
        kept.push_back(face);
        continue;
      }
      for (int i = 0; i < 3; ++i) {
        const int from = face[i];
        const int to = face[(i + 1) % 3];
        if (silhouette.erase({to, from}) == 0) silhouette.insert({from, to});
      }
    }
    for (const auto& [from, to] : silhouette) kept.push_back({from, to, p});
    hull = std::move(kept);
  }
  return hull;
}

/// Turns a profile of (radius, height), from bottom to top, around the z axis. \pre radii > 0
Mesh revolved(const std::vector<Vec2>& profile, double bottom, double top, int around) {
  std::vector<Vec3> positions = {Vec3(0, 0, bottom)};
  std::vector<Face> faces;
  for (const Vec2& ring : profile) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      positions.emplace_back(ring.x() * std::cos(angle), ring.x() * std::sin(angle), ring.y());
    }
  }
  positions.emplace_back(0, 0, top);
  const int tip = static_cast<int>(positions.size()) - 1;
  const int rings = static_cast<int>(profile.size());
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    const int last = 1 + (rings - 1) * around;
    faces.insert(faces.end(), {{0, 1 + next, 1 + i}, {tip, last + i, last + next}});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const int low = 1 + ring * around;
      const int high = low + around;
      faces.insert(faces.end(),
                   {{low + i, low + next, high + next}, {low + i, high + next, high + i}});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

}  // namespace

Mesh cube() {
  std::vector<Vec3> positions;
  for (int i = 0; i < 8; ++i) {
    positions.emplace_back((i & 4 ? 0.5 : -0.5), (i & 2 ? 0.5 : -0.5), (i & 1 ? 0.5 : -0.5));
  }
  return make_mesh(std::move(positions), {{0, 1, 3},
                                          {0, 3, 2},
                                          {4, 6, 7},
                                          {4, 7, 5},
                                          {0, 4, 5},
                                          {0, 5, 1},
                                          {2, 3, 7},
                                          {2, 7, 6},
                                          {0, 2, 6},
                                          {0, 6, 4},
                                          {1, 5, 7},
                                          {1, 7, 3}});
}

Mesh tetrahedron() {
  return make_mesh({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

Mesh icosahedron() {
  const double g = std::numbers::phi;
  std::vector<Vec3> positions = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                 {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                 {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& position : positions) position.normalize();
  return make_mesh(
      std::move(positions),
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

Mesh star() {
  const Mesh core = icosahedron();
  std::vector<Vec3> positions = core.positions;
  std::vector<Face> faces;
  for (const auto& [a, b, c] : core.faces) {
    const int tip = static_cast<int>(positions.size());
    const Vec3 centre = (core.positions[a] + core.positions[b] + core.positions[c]) / 3;
    positions.push_back(2 * centre.normalized());
    faces.insert(faces.end(), {{a, b, tip}, {b, c, tip}, {c, a, tip}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh torus(int around, int tube) {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < tube; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / tube;
      const double radius = 1 + 0.4 * std::cos(v);
      positions.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
      const int next_i = (i + 1) % around;
      const int next_j = (j + 1) % tube;
      const int a = i * tube + j;
      const int b = next_i * tube + j;
      const int c = next_i * tube + next_j;
      const int d = i * tube + next_j;
      faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh pretzel() {
  const auto is_full = [](const std::array<int, 3>& cell) {
    const auto& [x, y, z] = cell;
    const bool is_hole = y == 1 && (x == 1 || x == 3);
    return x >= 0 && x < 5 && y >= 0 && y < 3 && z == 0 && !is_hole;
  };
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  std::map<std::array<int, 3>, int> vertices;
  Random random(1);
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [known, is_new] = vertices.try_emplace(at, static_cast<int>(vertices.size()));
    if (is_new) {
      Vec3& place = positions.emplace_back(at[0], at[1], at[2]);
      for (const int axis : {0, 1, 2}) place[axis] += 0.3 * (random.uniform() - 0.5);
    }
    return known->second;
  };
  for (int cell = 0; cell < 15; ++cell) {
    const std::array<int, 3> at = {cell % 5, cell / 5, 0};
    for (int wall = 0; is_full(at) && wall < 6; ++wall) {
      const int axis = wall / 2;
      const int side = wall % 2;
      std::array<int, 3> beyond = at;
      beyond[axis] += side == 1 ? 1 : -1;
      if (is_full(beyond)) continue;
      std::array<std::array<int, 3>, 4> corners;
      corners.fill(at);
      for (auto& corner : corners) corner[axis] += side;
      for (const int i : {1, 2}) ++corners[i][(axis + 1) % 3];
      for (const int i : {2, 3}) ++corners[i][(axis + 2) % 3];
      if (side == 0) std::swap(corners[1], corners[3]);
      const int first = vertex(corners[0]);
      const int opposite = vertex(corners[2]);
      faces.push_back({first, vertex(corners[1]), opposite});
      faces.push_back({first, opposite, vertex(corners[3])});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh open_strip(int squares) {
  std::vector<Vec3> positions = {{0, 0, 0}, {0, 1, 0}};
  std::vector<Face> faces;
  for (int i = 0; i < squares; ++i) {
    positions.emplace_back(i + 1, 0, 0);
    positions.emplace_back(i + 1, 1, 0);
    const int a = 2 * i;
    faces.insert(faces.end(), {{a, a + 2, a + 3}, {a, a + 3, a + 1}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh open_sheet(int side) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) positions.emplace_back(x, y, 0);
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x;
      const int b = a + side + 1;
      faces.insert(faces.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
    }
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh two_sided_square() {
  // The diagonals differ, so that no edge has four faces.
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}});
}

Mesh accordion(const std::vector<double>& widths) {
  std::vector<Vec3> positions = {{0, 0, 0}, {0, 1, 0}};
  std::vector<Face> faces;
  const double slope = std::numbers::sqrt2 / 2;
  double x = 0;
  double z = 0;
  for (int i = 0; i < static_cast<int>(widths.size()); ++i) {
    x += slope * widths[i];
    z += i % 2 == 0 ? slope * widths[i] : -slope * widths[i];
    positions.emplace_back(x, 0, z);
    positions.emplace_back(x, 1, z);
    const int a = 2 * i;
    faces.insert(faces.end(), {{a, a + 2, a + 3}, {a, a + 3, a + 1}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh crossing_strip() {
  std::vector<Vec3> positions;
  for (const Vec2& p :
       {Vec2(-1, 2), Vec2(1.2, 1), Vec2(1, 0), Vec2(0, 0), Vec2(-0.2, 1), Vec2(2, 2.1)}) {
    positions.emplace_back(p.x(), 0, p.y());
    positions.emplace_back(p.x(), 1, p.y());
  }
  std::vector<Face> faces;
  for (int i = 0; i < 5; ++i) {
    const int a = 2 * i;
    faces.insert(faces.end(), {{a, a + 2, a + 3}, {a, a + 3, a + 1}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh saddle(int faces, double turn) {
  // Rim points at heights +-h over the unit circle: neighbours are seen from the centre at an angle
  // with cosine (cos(2 pi / n) - h^2) / (1 + h^2), which is to be that of turn / n.
  const double step = 2 * std::numbers::pi / faces;
  const double cosine = std::cos(turn / faces);
  const double height = std::sqrt((std::cos(step) - cosine) / (1 + cosine));
  std::vector<Vec3> positions = {Vec3::Zero()};
  std::vector<Face> fan;
  for (int i = 0; i < faces; ++i) {
    positions.emplace_back(std::cos(i * step), std::sin(i * step), i % 2 == 0 ? height : -height);
    fan.push_back({0, 1 + i, 1 + (i + 1) % faces});
  }
  return make_mesh(std::move(positions), std::move(fan));
}

Mesh saddle_with_apron(double turn, int quads) {
  const Mesh fan = saddle(8, turn);
  std::vector<Vec3> positions = fan.positions;
  std::vector<std::array<int, 3>> faces = fan.faces;
  const int outer = fan.vertex_count();
  for (int i = 1; i <= quads + 1; ++i) positions.push_back(2 * fan.positions[i] + Vec3(0, 0, 1));
  for (int i = 0; i < quads; ++i) {
    faces.push_back({i + 2, i + 1, outer + i});
    faces.push_back({i + 2, outer + i, outer + i + 1});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh dumbbell(int around) {
  constexpr int kRings = 7;  // of one sphere, up to the neck
  std::vector<Vec2> profile;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double polar = (std::numbers::pi - 0.2) * ring / kRings;  // the neck's radius is sin(0.2)
    profile.emplace_back(std::sin(polar), -1.2 - std::cos(polar));
  }
  for (int ring = kRings - 1; ring >= 0; --ring) {
    profile.emplace_back(profile[ring].x(), -profile[ring].y());
  }
  return revolved(profile, -2.2, 2.2, around);
}

Mesh bumpy_sphere(int faces) {
  // As many points around as between the poles: 2 around (rings - 1) + 2 around triangles.
  const int around = std::max(3, static_cast<int>(std::lround(std::sqrt(faces))));
  const int rings = std::max(2, static_cast<int>(std::lround(0.5 * faces / around)));
  std::vector<Vec2> profile;
  for (int ring = 1; ring <= rings; ++ring) {
    const double polar = std::numbers::pi * ring / (rings + 1);
    profile.emplace_back(std::sin(polar), -std::cos(polar));
  }
  Mesh sphere = revolved(profile, -1, 1, around);
  for (Vec3& p : sphere.positions) {
    p *= 1 + 0.15 * std::sin(5 * p.x() + 1) * std::sin(5 * p.y() + 2) * std::sin(5 * p.z() + 3);
  }
  return sphere;
}

Mesh bilateral(int faces) {
  Mesh mesh = bumpy_sphere(faces);
  for (Vec3& p : mesh.positions) {
    p.normalize();
    const double across = std::sin(4 * std::abs(p.x()) + 1);
    p *= 1 + 0.3 * across * std::sin(3 * p.y() + 2) * std::sin(4 * p.z() + 3);
  }
  return mesh;
}

PolygonSoup mobius_strip(int quads) {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
  for (int i = 0; i < quads; ++i) {
    const double u = 2 * std::numbers::pi * i / quads;
    const Vec3 outwards(std::cos(u), std::sin(u), 0);
    const Vec3 across = std::cos(u / 2) * outwards + std::sin(u / 2) * Vec3::UnitZ();
    positions.push_back(outwards - 0.3 * across);
    positions.push_back(outwards + 0.3 * across);
    const bool closing = i + 1 == quads;  // half a turn later, inner and outer have changed places
    const int next_inner = closing ? 1 : 2 * i + 2;
    const int next_outer = closing ? 0 : 2 * i + 3;
    polygons.push_back({2 * i, 2 * i + 1, next_outer, next_inner});
  }
  return soup(std::move(positions), polygons);
}

Mesh random_hull(std::uint64_t seed, int points) {
  Random random(seed);
  std::vector<Vec3> positions;
  while (static_cast<int>(positions.size()) < points) {
    const Vec3 p(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    // Uniform on the sphere: directions of points of the ball, away from its centre.
    if (p.norm() < 1 && p.norm() > 0.1) positions.push_back(p.normalized());
  }
  std::vector<Face> faces = convex_hull(positions);
  return make_mesh(std::move(positions), std::move(faces));
}

PolygonSoup soup(std::vector<Vec3> positions, const std::vector<std::vector<int>>& polygons) {
  PolygonSoup result;
  result.positions = std::move(positions);
  for (const std::vector<int>& polygon : polygons) {
    result.corners.insert(result.corners.end(), polygon.begin(), polygon.end());
    result.first_corner.push_back(static_cast<int>(result.corners.size()));
  }
  return result;
}

PolygonSoup soup_of(const Mesh& mesh) {
  std::vector<std::vector<int>> polygons;
  for (const auto& [a, b, c] : mesh.faces) polygons.push_back({a, b, c});
  return soup(mesh.positions, polygons);
}

std::string obj_of(const Mesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3& p : mesh.positions) {
    text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const auto& [a, b, c] : mesh.faces) {
    text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  return text.str();
}

double signed_volume(const Mesh& mesh, int component) {
  double sum = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.components[f] != component) continue;
    const auto& [a, b, c] = mesh.faces[f];
    sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  }
  return sum / 6;
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.face_count(); ++f) sum += face_area(mesh, f);
  return sum;
}

double sharpest_corner(const Triangle3& t) {
  double least = 180;
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = t[(i + 1) % 3] - t[i];
    const Vec3 b = t[(i + 2) % 3] - t[i];
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    least = std::min(least, angle * 180 / std::numbers::pi);
  }
  return least;
}

int border_edge_count(const Mesh& mesh) {
  int count = 0;
  for (const Mesh::Edge& edge : mesh.edges) count += edge.faces[1] == -1;
  return count;
}

}  // namespace foldwright::testing
