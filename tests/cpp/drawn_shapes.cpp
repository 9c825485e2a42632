#include "drawn_shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "craft_shapes.h"

namespace foldwright::testing {
namespace {

using Face = std::array<int, 3>;

}  // namespace

Mesh grid_cube(int n) {
  Solid solid = grid_cube_of(n, 2);
  for (Vec3& p : solid.positions) p -= Vec3(1, 1, 1);
  std::vector<Face> faces;
  for (const std::vector<int>& quad : solid.polygons) {
    faces.insert(faces.end(), {{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}});
  }
  return make_mesh(std::move(solid.positions), std::move(faces));
}

Mesh prism(int sides, double height) {
  std::vector<Vec3> positions;
  for (const double y : {0.0, height}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      positions.emplace_back(std::cos(angle), y, -std::sin(angle));
    }
  }
  std::vector<Face> faces;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    faces.push_back({i, next, sides + next});
    faces.push_back({i, sides + next, sides + i});
    if (i == 0 || next == 0) continue;
    faces.push_back({0, next, i});
    faces.push_back({sides, sides + i, sides + next});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

Mesh l_prism() {
  const std::vector<Vec2> corners = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Vec3> positions;
  for (const double z : {0, 1}) {
    for (const Vec2& corner : corners) positions.emplace_back(corner.x(), corner.y(), z);
  }
  std::vector<Face> faces;
  for (const auto& [a, b, c] : {Face{0, 1, 2}, Face{0, 2, 3}, Face{0, 3, 5}, Face{3, 4, 5}}) {
    faces.insert(faces.end(), {{a, c, b}, {a + 6, b + 6, c + 6}});
  }
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    faces.insert(faces.end(), {{i, j, j + 6}, {i, j + 6, i + 6}});
  }
  return make_mesh(std::move(positions), std::move(faces));
}

}  // namespace foldwright::testing
