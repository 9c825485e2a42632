#include "solids.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "meshes.h"

namespace foldwright::testing {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Solid dodecahedron() {
  const double long_side = std::numbers::phi;
  const double short_side = 1 / std::numbers::phi;
  Solid solid{"dodecahedron", {}, {}, 12};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) solid.positions.emplace_back(x, y, z);
      solid.positions.emplace_back(0, x * short_side, y * long_side);
      solid.positions.emplace_back(x * short_side, y * long_side, 0);
      solid.positions.emplace_back(y * long_side, 0, x * short_side);
    }
  }
  // The five corners furthest along each normal, by their angle around it.
  for (int axis = 0; axis < 3; ++axis) {
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-1.0, 1.0}) {
        Vec3 normal = Vec3::Zero();
        normal[axis] = s;
        normal[(axis + 2) % 3] = t * std::numbers::phi;
        normal.normalize();
        const Vec3 x = normal.unitOrthogonal();
        const Vec3 y = normal.cross(x);
        std::map<double, int> around;
        for (int v = 0; v < 20; ++v) {
          const Vec3& p = solid.positions[v];
          if (normal.dot(p) > 1.3) around[std::atan2(y.dot(p), x.dot(p))] = v;
        }
        solid.polygons.emplace_back();
        for (const auto& [angle, v] : around) solid.polygons.back().push_back(v);
      }
    }
  }
  return solid;
}

Solid tube(int sides) {
  Solid solid{"tube", {}, {}, sides};
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    for (const double z : {0.0, 2.0}) {
      solid.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
    const int next = (i + 1) % sides;
    solid.polygons.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  return solid;
}

Solid quad_torus(int around, int across) {
  Solid solid{"torus", {}, {}, around * across};
  const auto index = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = kTurn * i / around;
      const double v = kTurn * j / across;
      const double r = 1 + 0.5 * std::cos(v);
      solid.positions.emplace_back(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v));
      solid.polygons.push_back(
          {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  // Two of the six rings across are level: six quads around, as many as turn about the axis.
  solid.panels = around * (across - 2) + 2;
  return solid;
}

Solid tent() {
  return {"tent",
          {{0, 0, 0}, {2, 0, 0}, {2, 1, 0.8}, {0, 1, 0.8}, {2, 0, 1.7}, {0, 0, 1.7}},
          {{0, 1, 2, 3}, {3, 2, 4, 5}},
          2};
}

/// The surface of unit cubes at lattice points.
Solid voxels(std::string name, const std::set<std::array<int, 3>>& cubes, int panels) {
  Solid solid{std::move(name), {}, {}, panels};
  std::map<std::array<int, 3>, int> index_of;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [entry, is_new] = index_of.try_emplace(p, static_cast<int>(solid.positions.size()));
    if (is_new) solid.positions.emplace_back(p[0], p[1], p[2]);
    return entry->second;
  };
  for (const auto& cube : cubes) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = cube;
        beside[axis] += 2 * side - 1;
        if (cubes.contains(beside)) continue;
        std::vector<int> quad;
        for (const auto& [u, v] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          std::array<int, 3> corner = cube;
          corner[axis] += side;
          corner[(axis + 1) % 3] += side == 1 ? u : v;
          corner[(axis + 2) % 3] += side == 1 ? v : u;
          quad.push_back(vertex(corner));
        }
        solid.polygons.push_back(quad);
      }
    }
  }
  return solid;
}

}  // namespace

Solid prism_over(std::string name, const std::vector<Vec2>& base, double depth) {
  const int n = static_cast<int>(base.size());
  Solid solid{std::move(name), {}, {{}, {}}, n + 2};
  for (const double z : {0.0, depth}) {
    for (const Vec2& p : base) solid.positions.emplace_back(p.x(), p.y(), z);
  }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    solid.polygons[0].push_back((n - i) % n);
    solid.polygons[1].push_back(n + i);
    solid.polygons.push_back({i, next, n + next, n + i});
  }
  return solid;
}

std::vector<Solid> drawn_solids() {
  return {prism_over("cube", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1), dodecahedron(),
          prism_over("L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1), tube(16),
          quad_torus(8, 6), tent(),
          // A body of three cubes with two arms, one cube each: a cross lying down.
          voxels("cross", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, 14)};
}

PolygonSoup soup_of(const Solid& solid, double precision) {
  PolygonSoup polygons = soup(solid.positions, solid.polygons);
  polygons.precision = precision;
  return polygons;
}

}  // namespace foldwright::testing
