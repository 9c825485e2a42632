#include "paper/sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/input_error.h"
#include "meshes.h"
#include "paper/rows.h"
#include "trees.h"
#include "unfold/net.h"

namespace foldwright::testing {
namespace {

/// A rectangle of two triangles, turned by an odd angle.
Net rectangle(double width, double height) {
  Mesh mesh = open_strip(1);
  const RigidMotion2 turn{0.6, 0.8, Vec2(5, -3)};
  for (Vec3& p : mesh.positions) {
    const Vec2 q = turn(Vec2(width * p.x(), height * p.y()));
    p = Vec3(q.x(), q.y(), 0);
  }
  return make_net(mesh, build_dual_graph(mesh), {});
}

Box2 box_of(const Net& net) {
  Box2 box{1e300, 1e300, -1e300, -1e300};
  for (const Vec2& p : net.vertices) {
    box = {std::min(box.min[0], p.x()), std::min(box.min[1], p.y()), std::max(box.max[0], p.x()),
           std::max(box.max[1], p.y())};
  }
  return box;
}

/// The box of a net on its sheet.
Box2 placed(const Net& net, const Placement& place) {
  const Box2 box = box_of(net);
  return {place.x + box.min[0], place.y + box.min[1], place.x + box.max[0], place.y + box.max[1]};
}

double net_area(const Net& net) {
  double twice = 0;
  for (const auto& [a, b, c] : net.corners) {
    twice += cross(net.vertices[b] - net.vertices[a], net.vertices[c] - net.vertices[a]);
  }
  return twice / 2;
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

/// Least distance of the edges of two nets from each other, on their sheet.
double distance(const Net& a, const Placement& at_a, const Net& b, const Placement& at_b) {
  const Vec2 from_a_to_b(at_b.x - at_a.x, at_b.y - at_a.y);
  double least = 1e300;
  for (const NetEdge& e : a.edges) {
    const Vec2 p = a.vertices[e.vertices[0]];
    const Vec2 q = a.vertices[e.vertices[1]];
    for (const NetEdge& f : b.edges) {
      const Vec2 r = b.vertices[f.vertices[0]] + from_a_to_b;
      const Vec2 s = b.vertices[f.vertices[1]] + from_a_to_b;
      const bool cross_over = cross(q - p, r - p) * cross(q - p, s - p) < 0 &&
                              cross(s - r, p - r) * cross(s - r, q - r) < 0;
      if (cross_over) return 0;
      least = std::min(
          {least, distance(p, r, s), distance(q, r, s), distance(r, p, q), distance(s, p, q)});
    }
  }
  return least;
}

bool is_inside(const Vec2& p, const Net& net) {
  return std::ranges::any_of(net.corners, [&](const std::array<int, 3>& corners) {
    for (int i = 0; i < 3; ++i) {
      const Vec2& a = net.vertices[corners[i]];
      if (cross(net.vertices[corners[(i + 1) % 3]] - a, p - a) <= 0) return false;
    }
    return true;
  });
}

void expect_within_margins_and_apart(const std::vector<Net>& nets, const SheetLayout& layout,
                                     const SheetOptions& options) {
  ASSERT_EQ(layout.placements.size(), nets.size());
  std::vector<char> used(layout.sheet_count, 0);
  const double least = options.margin - 1e-9;
  const double ruled = ruled_margin(options) - 1e-9;
  for (std::size_t i = 0; i < nets.size(); ++i) {
    ASSERT_GE(layout.placements[i].sheet, 0);
    ASSERT_LT(layout.placements[i].sheet, layout.sheet_count);
    used[layout.placements[i].sheet] = 1;
    EXPECT_NEAR(box_of(nets[i]).min[0], 0, 1e-9);
    EXPECT_NEAR(box_of(nets[i]).min[1], 0, 1e-9);
    const Box2 box = placed(nets[i], layout.placements[i]);
    EXPECT_GE(box.min[0], ruled);
    EXPECT_GE(box.min[1], ruled);
    EXPECT_LE(box.max[0], layout.sheet_width - least);
    EXPECT_LE(box.max[1], layout.sheet_height - least);
    for (std::size_t j = 0; j < i; ++j) {
      if (layout.placements[i].sheet != layout.placements[j].sheet) continue;
      const Placement& other = layout.placements[j];
      EXPECT_GE(distance(nets[i], layout.placements[i], nets[j], other), options.gap - 1e-6)
          << i << " and " << j;
      const Vec2 shift(layout.placements[i].x - other.x, layout.placements[i].y - other.y);
      EXPECT_FALSE(is_inside(nets[i].vertices[0] + shift, nets[j])) << i << " and " << j;
    }
  }
  EXPECT_EQ(std::ranges::count(used, 0), 0) << "an empty sheet";
}

Footprint footprint_of(const Net& net) {
  Footprint print;
  for (const auto& [a, b, c] : net.corners) {
    print.polygons.push_back({net.vertices[a], net.vertices[b], net.vertices[c]});
  }
  print.face_area = net_area(net);
  return print;
}

/// Scales nets so that the largest just fits, lays them out, and moves them as the layout says.
SheetLayout fit_on_sheets(std::vector<Net>& nets, const SheetOptions& options = {}) {
  std::vector<Footprint> prints;
  for (const Net& net : nets) prints.push_back(footprint_of(net));
  const double scale = fitting_scale(prints, options);
  prints.clear();
  for (Net& net : nets) {
    for (Vec2& p : net.vertices) p *= scale;
    prints.push_back(footprint_of(net));
  }
  SheetLayout layout = lay_on_sheets({.pieces = prints, .options = options, .effort = 6});
  layout.scale = scale;
  for (std::size_t i = 0; i < nets.size(); ++i) {
    for (Vec2& p : nets[i].vertices) p = layout.turns[i](p);
  }
  return layout;
}

std::vector<Net> random_nets(Random& random, int count) {
  std::vector<Net> nets;
  for (int i = 0; i < count; ++i) {
    const Mesh mesh = random_hull(random.bits(), 4 + random.below(30));
    const DualGraph graph = build_dual_graph(mesh);
    nets.push_back(make_net(mesh, graph, random_tree(graph, random)));
    const double factor = 0.2 + random.uniform();
    for (Vec2& p : nets.back().vertices) p *= factor;
  }
  return nets;
}

TEST(LayOnSheets, KeepsNetsWithinTheMarginsAndApart) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Net> nets = random_nets(random, 1 + random.below(15));
    const std::vector<Net> before = nets;
    SheetOptions options;
    options.margin = 20 * random.uniform();
    options.gap = 10 * random.uniform();
    options.orientation = static_cast<Orientation>(random.below(3));
    const SheetLayout layout = fit_on_sheets(nets, options);
    expect_within_margins_and_apart(nets, layout, options);
    double area = 0;
    for (std::size_t i = 0; i < nets.size(); ++i) {
      area += net_area(nets[i]);
      const double factor = layout.scale * layout.scale;
      EXPECT_NEAR(net_area(nets[i]), factor * net_area(before[i]), 1e-9 * net_area(nets[i]));
    }
    const double paper = layout.sheet_count * layout.sheet_width * layout.sheet_height;
    EXPECT_NEAR(layout.efficiency, area / paper, 1e-12);
  }
}

TEST(LayOnSheets, MakesTheLargestNetJustFit) {
  std::vector<Net> nets = {rectangle(1, 2), rectangle(0.5, 0.5)};
  const SheetLayout layout = fit_on_sheets(nets, {.width = 120, .height = 220, .margin = 10});
  EXPECT_NEAR(layout.scale, 100, 1e-6);
  const Box2 box = placed(nets[0], layout.placements[0]);
  EXPECT_NEAR(box.min[0], 10, 1e-6);
  EXPECT_NEAR(box.max[0], 110, 1e-6);
  EXPECT_NEAR(box.min[1], 10, 1e-6);
  EXPECT_NEAR(box.max[1], 210, 1e-6);
}

TEST(LayOnSheets, TurnsTheSheetWhenThatSavesPaper) {
  const auto make_nets = [] { return std::vector<Net>{rectangle(1, 1.4), rectangle(1, 1.4)}; };
  // Two pieces of nearly the sheet's shape: on portrait each fills one sheet, and so on landscape.
  std::vector<Net> nets = make_nets();
  EXPECT_EQ(fit_on_sheets(nets, {.orientation = Orientation::kPortrait}).sheet_width, 210);
  nets = make_nets();
  EXPECT_EQ(fit_on_sheets(nets, {.orientation = Orientation::kLandscape}).sheet_width, 297);
  nets = make_nets();
  const SheetLayout chosen = fit_on_sheets(nets);
  EXPECT_EQ(chosen.sheet_width, 210) << "portrait among equals";
  // A long and a short piece that go below each other on a wide sheet only.
  std::vector<Net> long_and_short = {rectangle(2, 0.5), rectangle(1.2, 0.75)};
  const SheetLayout wide = fit_on_sheets(long_and_short, {.margin = 5});
  std::vector<Net> again = {rectangle(2, 0.5), rectangle(1.2, 0.75)};
  const SheetLayout tall =
      fit_on_sheets(again, {.margin = 5, .orientation = Orientation::kPortrait});
  EXPECT_LE(wide.sheet_count, tall.sheet_count);
}

TEST(LayOnSheets, KeepsRoomForRulersInNarrowMargins) {
  EXPECT_EQ(ruled_margin({.margin = 10}), 10);
  EXPECT_EQ(ruled_margin({.margin = 5}), 9.5);
  EXPECT_EQ(ruled_margin({.margin = 0}), 5.5);
}

TEST(LayOnSheets, PutsSmallPiecesOnOneSheet) {
  std::vector<Net> nets = {rectangle(1, 1.5)};
  for (int i = 0; i < 4; ++i) nets.push_back(rectangle(0.01, 0.01));
  nets[0] = rectangle(1, 0.5);
  EXPECT_EQ(fit_on_sheets(nets).sheet_count, 1);
}

TEST(LayOnSheets, NestsWhatBoxesCannot) {
  // Two right triangles of nearly the sheet's size, which together make its rectangle.
  Mesh mesh = make_mesh({{0, 0, 0}, {170, 0, 0}, {0, 260, 0}}, {{0, 1, 2}});
  const Net triangle = make_net(mesh, build_dual_graph(mesh), {});
  const std::vector<Footprint> prints(2, footprint_of(triangle));
  const SheetLayout layout = lay_on_sheets({.pieces = prints});
  EXPECT_EQ(layout.sheet_count, 1);
}

TEST(LayOnSheets, TakesNoMoreSheetsThanRowsOfBoxes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Extent> boxes;
    std::vector<Footprint> prints;
    for (int i = 0; i < 12; ++i) {
      const double width = 20 + 170 * random.uniform();
      const double height = 20 + 170 * random.uniform();
      boxes.push_back({width, height});
      prints.push_back({{{{0, 0}, {width, 0}, {width, height}, {0, height}}}, width * height});
    }
    const SheetOptions options = {.orientation = Orientation::kPortrait};
    const int rows = lay_in_rows(boxes, printable(options), options.gap).sheet_count;
    EXPECT_LE(lay_on_sheets({.pieces = prints, .options = options}).sheet_count, rows) << seed;
  }
}

TEST(LayOnSheets, LeavesPinnedPiecesWhereTheyAre) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Net> nets = random_nets(random, 8);
    for (Net& net : nets) {
      for (Vec2& p : net.vertices) p *= 12;
    }
    std::vector<Footprint> prints;
    std::vector<std::optional<Pin>> pins(8);
    for (const Net& net : nets) prints.push_back(footprint_of(net));
    const SheetOptions options = {.width = 300, .height = 400};
    pins[3] = Pin{{0, 20 + 40 * random.uniform(), 30}, 6 * random.uniform()};
    SheetLayout layout = lay_on_sheets({.pieces = prints, .options = options, .pins = pins});
    EXPECT_EQ(layout.placements[3].sheet, 0);
    EXPECT_EQ(layout.placements[3].x, pins[3]->place.x);
    EXPECT_EQ(layout.placements[3].y, 30);
    for (std::size_t i = 0; i < nets.size(); ++i) {
      for (Vec2& p : nets[i].vertices) p = layout.turns[i](p);
    }
    expect_within_margins_and_apart(nets, layout, options);
  }
}

TEST(LayOnSheets, RefusesPinsThatCannotStay) {
  std::vector<Net> nets = {rectangle(100, 50), rectangle(100, 50)};
  const std::vector<Footprint> prints = {footprint_of(nets[0]), footprint_of(nets[1])};
  const std::vector<std::string> names = {"A", "Wing"};
  const auto fault = [&](const Pin& first, const Pin& second) -> std::string {
    const std::vector<std::optional<Pin>> pins = {first, second};
    try {
      lay_on_sheets({.pieces = prints, .pins = pins, .names = names});
    } catch (const InputError& error) {
      EXPECT_EQ(error.code(), "bad-pin");
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault({{0, 10, 10}, 0}, {{1, 10, 10}, 0}), "");
  EXPECT_EQ(fault({{0, 10, 10}, 0}, {{0, 15, 15}, 0}),
            "bad-pin what=overlap pieces=A,Wing sheet=1");
  EXPECT_EQ(fault({{0, 10, 10}, 0}, {{2, 5, 10}, 0}), "bad-pin what=outside piece=Wing sheet=3");
}

TEST(LayOnSheets, MovesPinnedPiecesIntoThePrintableAreaIfTheyStickOutByLittle) {
  const std::vector<Net> nets = {rectangle(100, 50)};
  const std::vector<Footprint> prints = {footprint_of(nets[0])};
  const std::vector<std::string> names = {"A"};
  const SheetOptions options = {
      .width = 210, .height = 297, .margin = 10, .orientation = Orientation::kPortrait};
  const auto place = [&](double x, double y) {
    const std::vector<std::optional<Pin>> pins = {Pin{{0, x, y}, 0}};
    SheetTask task = {.pieces = prints, .options = options, .pins = pins, .names = names};
    task.pin_play = 5;
    const Placement placed = lay_on_sheets(task).placements[0];
    return Vec2(placed.x, placed.y);
  };
  const double low = ruled_margin(options);
  EXPECT_EQ(place(20, 30), Vec2(20, 30));
  EXPECT_EQ(place(low - 3, 30), Vec2(low, 30));
  EXPECT_EQ(place(100 + 4, 297 - 10 - 50 + 5), Vec2(100, 297 - 10 - 50));
  EXPECT_THROW(place(100 + 5.1, 30), InputError);
}

TEST(LayOnSheets, RefusesMarginsThatLeaveNothing) {
  std::vector<Net> nets = {rectangle(1, 1)};
  try {
    fit_on_sheets(nets, {.width = 100, .height = 200, .margin = 50});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "bad-margin");
  }
}

Footprint print_of(std::vector<Vec2> polygon) { return {.polygons = {std::move(polygon)}}; }

TEST(FitsSomehow, TurnsAPieceUprightOrAlongTheDiagonal) {
  const Footprint rectangle = print_of({{0, 0}, {4, 0}, {4, 1}, {0, 1}});
  EXPECT_TRUE(fits_somehow(rectangle, {4, 1}));
  EXPECT_TRUE(fits_somehow(rectangle, {1, 4}));
  EXPECT_FALSE(fits_somehow(rectangle, {3.9, 0.9}));
  const Footprint stick = print_of({{0, 0}, {12, 0}, {12, 0.1}, {0, 0.1}});
  EXPECT_TRUE(fits_somehow(stick, {9, 9}));
  EXPECT_FALSE(fits_somehow(stick, {8, 8}));
}

TEST(TurnsOf, HaveTheOneThatIsKnownToFitOnEitherSheet) {
  Footprint piece = print_of({{0, 0}, {50, 0}, {40, 30}});
  const double angle = 0.3;  // along no edge, and between the steps of 3 degrees
  piece.fitting_turn = {std::cos(angle), std::sin(angle)};
  const auto has = [&](double wanted) {
    return std::ranges::any_of(turns_of(piece, convex_hull(piece.points())), [&](const Turn& turn) {
      return std::hypot(turn.c - std::cos(wanted), turn.s - std::sin(wanted)) < 1e-12;
    });
  };
  EXPECT_TRUE(has(angle));
  EXPECT_TRUE(has(angle - std::numbers::pi / 2)) << "with the sheet on its side";
  piece.fitting_turn.reset();
  EXPECT_FALSE(has(angle));
}

}  // namespace
}  // namespace foldwright::testing
