#include "paper/flaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "drawn_shapes.h"
#include "geometry/convex2.h"
#include "mesh/input_error.h"
#include "meshes.h"
#include "nets.h"

namespace foldwright::testing {
namespace {

double area_of(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice / 2;
}

/// Area of the intersection of two convex polygons, as fans of triangles.
double shared_area(std::span<const Vec2> a, std::span<const Vec2> b) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    for (std::size_t j = 1; j + 1 < b.size(); ++j) {
      const Triangle2 s = {a[0], a[i], a[i + 1]};
      const Triangle2 t = {b[0], b[j], b[j + 1]};
      if (area_of(s) > 1e-12 && area_of(t) > 1e-12) area += intersection_area(s, t);
    }
  }
  return area;
}

std::vector<Vec2> face_of(const Net& net, int face) {
  const auto& [a, b, c] = net.corners[face];
  return {net.vertices[a], net.vertices[b], net.vertices[c]};
}

/// Lengths of a flap's neighbour: the triangle into which the flap must fit.
void expect_inside_neighbour(const Mesh& mesh, const Net& net, const Flap& flap, double size) {
  const NetEdge& edge = net.edges[flap.edge];
  const Vec2 a = net.vertices[edge.vertices[0]];
  const Vec2 b = net.vertices[edge.vertices[1]];
  // Of the two faces of the mesh edge, one has this side; the flap fits one of them at least.
  bool fits_one = false;
  for (const int face : mesh.edges[edge.mesh_edge].faces) {
    const auto& ends = mesh.edges[edge.mesh_edge].vertices;
    for (const int corner : mesh.faces[face]) {
      if (corner == ends[0] || corner == ends[1]) continue;
      for (const int start : {0, 1}) {
        const Vec3 from = mesh.positions[ends[start]];
        const Vec3 along = (mesh.positions[ends[1 - start]] - from).normalized();
        const Vec3 off = mesh.positions[corner] - from;
        const double x = along.dot(off) * size / 2;
        const double y = (off - along.dot(off) * along).norm() * size / 2;
        const Vec2 axis = (b - a).normalized();
        const Vec2 apex = a + x * axis + y * Vec2(axis.y(), -axis.x());
        bool inside = true;
        for (const Vec2& p : flap.corners) {
          inside = inside && cross(apex - a, p - a) > -1e-6 && cross(b - apex, p - apex) > -1e-6;
        }
        fits_one = fits_one || inside;
      }
    }
  }
  EXPECT_TRUE(fits_one) << "flap of edge " << flap.edge;
}

void expect_sound(const Mesh& mesh, const Net& net, const std::vector<Flap>& flaps, double size) {
  for (std::size_t i = 0; i < flaps.size(); ++i) {
    const auto& corners = flaps[i].corners;
    const NetEdge& edge = net.edges[flaps[i].edge];
    EXPECT_EQ(edge.assignment, Assignment::kCut);
    EXPECT_GT(area_of(corners), 0);
    EXPECT_DOUBLE_EQ(flaps[i].angle, fold_angle(mesh, edge.mesh_edge));
    expect_inside_neighbour(mesh, net, flaps[i], size);
    for (int face = 0; face < static_cast<int>(net.corners.size()); ++face) {
      EXPECT_LT(shared_area(corners, face_of(net, face)), 1e-4);
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LT(shared_area(corners, flaps[j].corners), 1e-4);
    }
  }
}

TEST(PlaceFlaps, OverlapsNothingAndHidesBehindTheNeighbour) {
  for (const int faces : {60, 200, 600}) {
    for (const double size : {40.0, 150.0}) {
      SCOPED_TRACE(::testing::Message() << faces << " faces, " << size << " mm");
      const Mesh mesh = bumpy_sphere(faces);
      const std::vector<Net> nets = {net_of(mesh, size)};
      for (const FlapSide side : {FlapSide::kOne, FlapSide::kAlternate, FlapSide::kBoth}) {
        const FlapPlan plan = place_flaps(mesh, nets, {side, {}});
        expect_sound(mesh, nets[0], plan.flaps[0], size);
        const FlapCounts& counts = plan.counts;
        EXPECT_EQ(counts.full + counts.shrunk + static_cast<int>(plan.missed.size()),
                  counts.wanted);
      }
    }
  }
}

TEST(PlaceFlaps, GivesEachSeamOneFlapOrTwo) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  for (const FlapSide side : {FlapSide::kOne, FlapSide::kAlternate, FlapSide::kBoth}) {
    const FlapPlan plan = place_flaps(mesh, nets, {side, {}});
    std::map<int, int> flaps;  // by mesh edge
    for (const Flap& flap : plan.flaps[0]) ++flaps[nets[0].edges[flap.edge].mesh_edge];
    EXPECT_EQ(flaps.size(), 7u) << "the seams of a cube's net";
    EXPECT_EQ(plan.counts.full, 7);
    for (const auto& [edge, count] : flaps) {
      EXPECT_EQ(count, side == FlapSide::kBoth ? 2 : 1);
    }
  }
  EXPECT_TRUE(place_flaps(mesh, nets, {FlapSide::kNone, {}}).flaps[0].empty());
}

TEST(PlaceFlaps, GivesAStraightRunOneFlapAsWideAsItsPanel) {
  const Mesh mesh = grid_cube(4);
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const FlapPlan plan = place_flaps(mesh, nets, {});
  ASSERT_EQ(plan.flaps[0].size(), 7u);
  EXPECT_EQ(plan.counts.full, 7);
  for (const Flap& flap : plan.flaps[0]) {
    const Vec2 base = nets[0].vertices[flap.base[1]] - nets[0].vertices[flap.base[0]];
    EXPECT_NEAR(base.norm(), 80, 1e-9);
    const double top = (flap.corners[2] - flap.corners[1]).norm();
    EXPECT_NEAR(top, 80 - 2 * 5 / std::sqrt(3.0), 0.3) << "sides as steep as they may be";
  }
}

TEST(PlaceFlaps, SharesConcaveCornersByHalf) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const FlapPlan plan = place_flaps(mesh, nets, {FlapSide::kBoth, {}});
  // At the inner corners of the cross two flaps meet at right angles.
  for (const Flap& flap : plan.flaps[0]) {
    EXPECT_EQ(flap.height, 5);
    const double left = (flap.corners[0] - nets[0].vertices[flap.base[0]]).norm();
    const double right = (flap.corners[3] - nets[0].vertices[flap.base[1]]).norm();
    EXPECT_LT(std::max(left, right), 1e-6) << "every foot stands at the end of its edge";
  }
}

/// Per edge of the cube's net with a flap: whether it is on the left of the mesh edge.
std::multimap<int, bool> sides_with_flaps(const Mesh& mesh, const Net& net, const FlapPlan& plan) {
  std::multimap<int, bool> sides;
  for (const Flap& flap : plan.flaps[0]) {
    const NetEdge& edge = net.edges[flap.edge];
    for (std::size_t f = 0; f < net.faces.size(); ++f) {
      for (int i = 0; i < 3; ++i) {
        const bool is_here = net.corners[f][i] == edge.vertices[0] &&
                             net.corners[f][(i + 1) % 3] == edge.vertices[1];
        if (is_here) {
          sides.emplace(edge.mesh_edge, mesh.edges[edge.mesh_edge].faces[0] == net.faces[f]);
        }
      }
    }
  }
  return sides;
}

TEST(PlaceFlaps, FollowsAChoiceForAnEdge) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const FlapPlan plain = place_flaps(mesh, nets, {});
  const int edge = nets[0].edges[plain.flaps[0][0].edge].mesh_edge;
  const auto [from, to] = mesh.edges[edge].vertices;
  const auto sides_for = [&](int u, int v, EdgeFlaps flaps) {
    const FlapPlan plan =
        place_flaps(mesh, nets, {.choices = {{u, v, EdgeFlaps::kBoth}, {u, v, flaps}}});
    EXPECT_EQ(plan.counts.wanted, flaps == EdgeFlaps::kNone ? 6 : 7);
    const auto sides = sides_with_flaps(mesh, nets[0], plan);
    std::multiset<bool> found;
    for (auto [at, end] = sides.equal_range(edge); at != end; ++at) found.insert(at->second);
    return found;
  };
  EXPECT_EQ(sides_for(from, to, EdgeFlaps::kNone), std::multiset<bool>{});
  EXPECT_EQ(sides_for(from, to, EdgeFlaps::kLeft), std::multiset<bool>{true});
  EXPECT_EQ(sides_for(from, to, EdgeFlaps::kRight), std::multiset<bool>{false});
  EXPECT_EQ(sides_for(to, from, EdgeFlaps::kLeft), std::multiset<bool>{false});
  EXPECT_EQ(sides_for(to, from, EdgeFlaps::kBoth), (std::multiset<bool>{false, true}));
  const FlapPlan only =
      place_flaps(mesh, nets, {.side = FlapSide::kNone, .choices = {{from, to, EdgeFlaps::kBoth}}});
  EXPECT_EQ(only.flaps[0].size(), 2u);
  EXPECT_EQ(only.counts.wanted, 1);
}

TEST(PlaceFlaps, RefusesAChoiceForAnEdgeThatIsNotThere) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  try {
    place_flaps(mesh, nets, {.choices = {{0, 99, EdgeFlaps::kBoth}}});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "bad-option what=flap-edge from=0 to=99");
  }
}

TEST(PlaceFlaps, MakesAFlapAsHighAsAsked) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const FlapPlan usual = place_flaps(mesh, nets, {});
  const Flap& first = usual.flaps[0][0];
  const Mesh::Edge& edge = mesh.edges[nets[0].edges[first.edge].mesh_edge];
  const auto height_for = [&](double height) {
    const FlapChoice choice = {edge.vertices[1], edge.vertices[0], EdgeFlaps::kUsual, height};
    const FlapPlan plan = place_flaps(mesh, nets, {.choices = {choice}});
    EXPECT_EQ(plan.flaps[0].size(), usual.flaps[0].size());
    EXPECT_EQ(plan.counts.full, 7) << "a lower one is full where it was asked for";
    double found = 0;
    for (const Flap& flap : plan.flaps[0]) {
      const bool is_it = nets[0].edges[flap.edge].mesh_edge == nets[0].edges[first.edge].mesh_edge;
      if (is_it) found = flap.height;
      if (!is_it) {
        EXPECT_EQ(flap.height, 5);
      }
    }
    return found;
  };
  EXPECT_EQ(height_for(0), 5);
  EXPECT_EQ(height_for(9), 9);
  EXPECT_EQ(height_for(1.5), 1.5) << "lower than what is worth trying elsewhere";
}

TEST(PlaceFlaps, PutsFlapsOnBordersIfAsked) {
  const Mesh mesh = open_strip(3);
  const std::vector<Net> nets = {net_of(mesh, 60)};
  EXPECT_TRUE(place_flaps(mesh, nets, {}).flaps[0].empty());
  const FlapPlan plan = place_flaps(mesh, nets, {.borders = true});
  EXPECT_EQ(plan.counts.borders, 4) << "the sides of three squares in a row";
  EXPECT_EQ(plan.counts.wanted, 0);
  for (const Flap& flap : plan.flaps[0]) {
    EXPECT_EQ(flap.height, 5);
    EXPECT_EQ(flap.angle, 0);
  }
  const Mesh::Edge& edge = mesh.edges[nets[0].edges[plan.flaps[0][0].edge].mesh_edge];
  const FlapChoice none = {edge.vertices[0], edge.vertices[1], EdgeFlaps::kNone};
  EXPECT_EQ(place_flaps(mesh, nets, {.borders = true, .choices = {none}}).counts.borders, 3);
}

TEST(PlaceFlaps, TellsWhyThereIsNone) {
  // Each face is 1.5 mm thin across its long edges.
  const Mesh thin = accordion({1, 1, 1});
  const std::vector<Net> strip = {net_of(thin, 3)};
  EXPECT_EQ(place_flaps(thin, strip, {}).counts.wanted, 0) << "borders need none";
  const Mesh sphere = bumpy_sphere(600);
  const std::vector<Net> small = {net_of(sphere, 60)};
  const FlapPlan plan = place_flaps(sphere, small, {});
  EXPECT_GT(plan.missed.size(), 0u);
  EXPECT_NEAR(plan.counts.missing_length / plan.counts.wanted_length,
              static_cast<double>(plan.missed.size()) / plan.counts.wanted, 0.15);
  for (const MissedFlap& miss : plan.missed) EXPECT_NE(miss.why, FlapMiss::kShort);
  const FlapPlan flat = place_flaps(sphere, small, {FlapSide::kOne, {.angles = {0.3, 0.3}}});
  EXPECT_EQ(flat.missed.front().why, FlapMiss::kShort) << "sides of 17 degrees need 13 mm";
}

TEST(PlaceFlaps, KeepsOffWhereItIsTold) {
  const Mesh mesh = cube();
  const std::vector<Net> nets = {net_of(mesh, 80)};
  const Box2 box = box_of(nets[0].vertices);
  const auto [x0, y0] = box.min;
  const auto [x1, y1] = box.max;
  const double far = 20;
  const std::vector<std::vector<std::vector<Vec2>>> around = {
      {{{x0 - far, y0 - far}, {x0, y0 - far}, {x0, y1 + far}, {x0 - far, y1 + far}},
       {{x1, y0 - far}, {x1 + far, y0 - far}, {x1 + far, y1 + far}, {x1, y1 + far}},
       {{x0 - far, y0 - far}, {x1 + far, y0 - far}, {x1 + far, y0}, {x0 - far, y0}},
       {{x0 - far, y1}, {x1 + far, y1}, {x1 + far, y1 + far}, {x0 - far, y1 + far}}}};
  const FlapPlan plan = place_flaps(mesh, nets, {}, around);
  EXPECT_GT(plan.flaps[0].size(), 0u);
  for (const Flap& flap : plan.flaps[0]) {
    for (const Vec2& p : flap.corners) {
      EXPECT_TRUE(p.x() > x0 - 1e-6 && p.x() < x1 + 1e-6 && p.y() > y0 - 1e-6 && p.y() < y1 + 1e-6);
    }
  }
  for (const MissedFlap& miss : plan.missed) EXPECT_EQ(miss.why, FlapMiss::kBlocked);
}

}  // namespace
}  // namespace foldwright::testing
