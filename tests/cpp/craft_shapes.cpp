#include "craft_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <sstream>
#include <tuple>
#include <utility>

#include "geometry/random.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Rings of points around the y axis, from below; the lowest is closed by a polygon if `bottom`,
/// the highest likewise. A radius of 0 is a tip.
Solid revolved(std::string name, const std::vector<Vec2>& profile, int around, bool bottom,
               bool top) {
  Solid solid{std::move(name), {}, {}};
  std::vector<std::vector<int>> rings;
  for (const Vec2& p : profile) {
    std::vector<int>& ring = rings.emplace_back();
    for (int i = 0; i < around; ++i) {
      if (i == 0 || p.x() > 0) {
        const double angle = kTurn * i / around;
        ring.push_back(static_cast<int>(solid.positions.size()));
        solid.positions.emplace_back(p.x() * std::cos(angle), p.y(), -p.x() * std::sin(angle));
      } else {
        ring.push_back(ring.front());
      }
    }
  }
  if (bottom) solid.polygons.emplace_back(rings.front().rbegin(), rings.front().rend());
  if (top) solid.polygons.push_back(rings.back());
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around;
      std::vector<int> side = {rings[r][i], rings[r][next], rings[r + 1][next]};
      if (rings[r + 1][next] != rings[r + 1][i]) side.push_back(rings[r + 1][i]);
      solid.polygons.push_back(side);
    }
  }
  return solid;
}

Solid scaled_solid(const std::string& name, double scale) {
  std::vector<Solid> solids = drawn_solids();
  Solid solid = *std::ranges::find(solids, name, &Solid::name);
  for (Vec3& p : solid.positions) p *= scale;
  return solid;
}

Solid cup() {
  const Solid body = revolved("", {{30, 0}, {30, 70}}, 32, true, false);
  // A handle with a profile like a C, 10 mm wide, that touches the wall at its ends.
  Solid handle = prism_over("",
                            {{30, 12},
                             {52, 12},
                             {58, 18},
                             {58, 52},
                             {52, 58},
                             {30, 58},
                             {30, 50},
                             {49, 50},
                             {50, 49},
                             {50, 21},
                             {49, 20},
                             {30, 20}},
                            10);
  for (Vec3& p : handle.positions) p.z() -= 5;
  return together("cup", {body, handle});
}

Solid ring_of_strips(int around, int across) {
  Solid solid{"torus", {}, {}};
  const auto index = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = kTurn * i / around;
      const double v = kTurn * (j + 0.5) / across;
      const double r = 50 + 20 * std::cos(v);
      solid.positions.emplace_back(r * std::cos(u), r * std::sin(u), 20 * std::sin(v));
      solid.polygons.push_back(
          {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return solid;
}

/// Its gables have a doorway cut out, and the front one is drawn as two halves.
Solid house() {
  Solid solid = prism_over("house",
                           {{0, 0},
                            {14, 0},
                            {14, 20},
                            {20, 20},
                            {26, 20},
                            {26, 0},
                            {40, 0},
                            {40, 35},
                            {20, 60},
                            {0, 35}},
                           60);
  const int n = 10;
  solid.polygons[1] = {n + 0, n + 1, n + 2, n + 3, n + 8, n + 9};
  solid.polygons.push_back({n + 3, n + 4, n + 5, n + 6, n + 7, n + 8});
  return solid;
}

Solid hinged_box() {
  const double w = 80, d = 50, h = 30;
  // The lid leans back from the upper edge of the wall at z = 0.
  return {"hinged box",
          {{0, 0, 0},
           {w, 0, 0},
           {w, 0, d},
           {0, 0, d},
           {0, h, 0},
           {w, h, 0},
           {w, h, d},
           {0, h, d},
           {0, h + 40, -30},
           {w, h + 40, -30}},
          {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}, {5, 4, 8, 9}}};
}

Solid terrain() {
  Solid solid{"terrain", {}, {}};
  constexpr int kCells = 5;
  Random random(3);
  for (int z = 0; z <= kCells; ++z) {
    for (int x = 0; x <= kCells; ++x) {
      solid.positions.emplace_back(25 * x, 12 * random.uniform(), 25 * z);
    }
  }
  for (int z = 0; z < kCells; ++z) {
    for (int x = 0; x < kCells; ++x) {
      const int a = z * (kCells + 1) + x;
      const int b = a + kCells + 1;
      solid.polygons.push_back({a, b, b + 1});
      solid.polygons.push_back({a, b + 1, a + 1});
    }
  }
  return solid;
}

Solid icosphere() {
  const Mesh mesh = icosahedron();
  Solid solid{"icosphere", mesh.positions, {}};
  std::map<std::array<int, 2>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.emplace(std::array{std::min(a, b), std::max(a, b)},
                                                 static_cast<int>(solid.positions.size()));
    if (is_new) {
      solid.positions.push_back((solid.positions[a] + solid.positions[b]).normalized());
    }
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    for (const auto& face : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) {
      solid.polygons.emplace_back(face.begin(), face.end());
    }
  }
  for (Vec3& p : solid.positions) p *= 45;
  return solid;
}

std::vector<Vec2> vase_profile() {
  std::vector<Vec2> profile;
  for (int i = 0; i <= 12; ++i) {
    const double t = i / 12.0;
    profile.emplace_back(28 + 12 * std::sin(1.6 * std::numbers::pi * t), 120 * t);
  }
  return profile;
}

/// Edges of the polygons, with the number of polygons on each.
std::map<std::array<int, 2>, int> edges_of(const Solid& solid) {
  std::map<std::array<int, 2>, int> edges;
  for (const std::vector<int>& polygon : solid.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = polygon[i];
      const int b = polygon[(i + 1) % polygon.size()];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  return edges;
}

/// Length of the shortest edges that join all corners; those of a border are one place.
double shortest_cuts(const Solid& solid) {
  std::vector<int> group(solid.positions.size());
  std::iota(group.begin(), group.end(), 0);
  const auto find = [&](int v) {
    while (group[v] != v) v = group[v] = group[group[v]];
    return v;
  };
  std::vector<std::tuple<double, int, int>> edges;
  for (const auto& [ends, count] : edges_of(solid)) {
    const auto [a, b] = ends;
    if (count == 1) {
      group[find(a)] = find(b);
    } else {
      edges.emplace_back((solid.positions[a] - solid.positions[b]).norm(), a, b);
    }
  }
  std::ranges::sort(edges);
  double sum = 0;
  for (const auto& [length, a, b] : edges) {
    if (find(a) == find(b)) continue;
    group[find(a)] = find(b);
    sum += length;
  }
  return sum;
}

double chord(double radius, int around) { return 2 * radius * std::sin(std::numbers::pi / around); }

/// Bands of 24 around, each glued to the next, and each closed once; the lowest with the bottom.
double vase_by_hand() {
  const std::vector<Vec2> profile = vase_profile();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    sum += (profile[i + 1] - profile[i]).norm();
    if (i > 0) sum += 24 * chord(profile[i].x(), 24);
  }
  return sum + 23 * chord(profile[0].x(), 24);
}

/// Sixteen strips of eight across, each closed once, and glued to the next.
double torus_by_hand() {
  return 16 * 8 * chord(20, 8) + 16 * chord(50 - 20 * std::cos(std::numbers::pi / 8), 16);
}

CraftShape as_cut(Solid solid, int pieces) {
  const double by_hand = shortest_cuts(solid);
  return {std::move(solid), by_hand, pieces};
}

}  // namespace

std::vector<CraftShape> craft_shapes() {
  std::vector<CraftShape> shapes;
  shapes.push_back(as_cut(grid_cube_of(1, 60), 1));
  shapes.push_back({grid_cube_of(4, 60), 7 * 60, 1});
  shapes.push_back(as_cut(scaled_solid("dodecahedron", 20), 1));
  shapes.push_back(as_cut(revolved("prism 6", {{30, 0}, {30, 60}}, 6, true, true), 1));
  shapes.push_back(as_cut(revolved("cylinder 32", {{30, 0}, {30, 60}}, 32, true, true), 1));
  shapes.push_back(as_cut(revolved("cone 24", {{30, 0}, {0, 60}}, 24, true, false), 1));
  shapes.push_back(as_cut(cup(), 2));
  shapes.push_back({ring_of_strips(16, 8), torus_by_hand(), 16});
  shapes.push_back(as_cut(house(), 1));
  shapes.push_back(as_cut(scaled_solid("L", 30), 2));
  shapes.push_back(as_cut(hinged_box(), 1));
  shapes.push_back(as_cut(terrain(), 1));
  shapes.push_back(as_cut(icosphere(), 1));
  shapes.push_back({revolved("vase 24x12", vase_profile(), 24, true, false), vase_by_hand(), 12});
  return shapes;
}

Solid grid_cube_of(int n, double side) {
  Solid solid{n == 1 ? "cube" : "grid cube", {}, {}};
  std::map<std::array<int, 3>, int> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = vertices.emplace(at, static_cast<int>(solid.positions.size()));
    if (is_new) solid.positions.push_back(side / n * Vec3(at[0], at[1], at[2]));
    return found->second;
  };
  for (const int axis : {0, 1, 2}) {
    for (const int level : {0, n}) {
      for (int i = 0; i < n * n; ++i) {
        const auto corner = [&](int x, int y) {
          std::array<int, 3> at;
          at[axis] = level;
          at[(axis + 1) % 3] = i % n + x;
          at[(axis + 2) % 3] = i / n + y;
          return vertex(at);
        };
        std::vector<int> quad = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (level == 0) std::ranges::reverse(quad);
        solid.polygons.push_back(quad);
      }
    }
  }
  return solid;
}

Solid together(std::string name, const std::vector<Solid>& solids) {
  Solid all{std::move(name), {}, {}};
  for (const Solid& solid : solids) {
    const auto first = static_cast<int>(all.positions.size());
    all.positions.insert(all.positions.end(), solid.positions.begin(), solid.positions.end());
    for (std::vector<int> polygon : solid.polygons) {
      for (int& corner : polygon) corner += first;
      all.polygons.push_back(std::move(polygon));
    }
  }
  return all;
}

std::string obj_of(const Solid& solid) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3& p : solid.positions) {
    text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const std::vector<int>& polygon : solid.polygons) {
    text << 'f';
    for (const int corner : polygon) text << ' ' << corner + 1;
    text << '\n';
  }
  return text.str();
}

}  // namespace foldwright::testing
