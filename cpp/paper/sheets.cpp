#include "paper/sheets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

// The largest piece stays this share below the printable size, so that rounding cannot clip it.
constexpr double kFitSlack = 1 - 1e-9;

struct Size {
  double width = 0, height = 0;
};

struct Area {
  Size sheet;      ///< the whole paper
  Size printable;  ///< within the margins
};

/// A way to turn a net: the rotation, and its box then.
struct Turn {
  double c = 1, s = 0;
  Size box;
};

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vec2> hull;
  const auto extend = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *it - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  extend(points.begin(), points.end());
  extend(points.rbegin(), points.rend());
  return hull;
}

Size turned_box(std::span<const Vec2> points, double c, double s) {
  Vec2 low(1e300, 1e300);
  Vec2 high = -low;
  for (const Vec2& p : points) {
    const Vec2 q(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  return {high.x() - low.x(), high.y() - low.y()};
}

/// The turns worth trying: each edge of the hull along either axis. A smallest enclosing box has a
/// side on the hull.
std::vector<Turn> make_turns(const Net& net) {
  const std::vector<Vec2> hull = convex_hull(net.vertices);
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    for (const auto& [c, s] : {std::pair(along.x(), -along.y()), std::pair(along.y(), along.x())}) {
      turns.push_back({c, s, turned_box(hull, c, s)});
    }
  }
  return turns;
}

double fitting_scale(const Turn& turn, const Size& room) {
  return std::min(room.width / turn.box.width, room.height / turn.box.height);
}

/// The largest scale at which some turn of every net fits.
double common_scale(const std::vector<std::vector<Turn>>& turns, const Size& room) {
  double scale = std::numeric_limits<double>::infinity();
  for (const auto& of_net : turns) {
    double best = 0;
    for (const Turn& turn : of_net) best = std::max(best, fitting_scale(turn, room));
    scale = std::min(scale, best);
  }
  return scale * kFitSlack;
}

/// Among the turns that fit, the one with the smallest box; wider than high among near equals,
/// since rows waste less with low pieces.
Turn choose_turn(std::span<const Turn> turns, double scale, const Size& room) {
  const Turn* best = nullptr;
  const auto cost = [](const Turn& t) {
    return t.box.width * t.box.height * (1 + 0.05 * t.box.height / (t.box.width + t.box.height));
  };
  for (const Turn& turn : turns) {
    if (fitting_scale(turn, room) < scale) continue;
    if (best == nullptr || cost(turn) < cost(*best)) best = &turn;
  }
  return *best;
}

struct Row {
  int sheet;
  double y, height, used;
};

/// Rows of boxes, high ones first; each box goes to the first row or sheet that has room.
std::vector<Placement> place_in_rows(std::span<const Size> boxes, const Area& area,
                                     const SheetOptions& options, int& sheet_count) {
  std::vector<int> by_height(boxes.size());
  std::iota(by_height.begin(), by_height.end(), 0);
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](int a, int b) { return boxes[a].height > boxes[b].height; });
  std::vector<Row> rows;
  std::vector<double> filled;  // height used, per sheet
  std::vector<Placement> placements(boxes.size());
  const auto open_row = [&](const Size& box) -> Row& {
    int sheet = 0;
    const auto start = [&](int s) { return filled[s] > 0 ? filled[s] + options.gap : 0; };
    while (sheet < static_cast<int>(filled.size()) &&
           start(sheet) + box.height > area.printable.height) {
      ++sheet;
    }
    if (sheet == static_cast<int>(filled.size())) filled.push_back(0);
    rows.push_back({sheet, start(sheet), box.height, 0});
    filled[sheet] = rows.back().y + box.height;
    return rows.back();
  };
  for (const int i : by_height) {
    const Size& box = boxes[i];
    const auto start = [&](const Row& row) { return row.used > 0 ? row.used + options.gap : 0; };
    const auto fits = [&](const Row& row) {
      return box.height <= row.height && start(row) + box.width <= area.printable.width;
    };
    const auto found = std::find_if(rows.begin(), rows.end(), fits);
    Row& row = found != rows.end() ? *found : open_row(box);
    // Sheets fill from the top, so that what is left over is one strip at the bottom.
    const double top = area.sheet.height - options.margin - row.y;
    placements[i] = {row.sheet, options.margin + start(row), top - box.height};
    row.used = start(row) + box.width;
  }
  sheet_count = static_cast<int>(filled.size());
  return placements;
}

double net_area(const Net& net) {
  double twice = 0;
  for (const auto& [a, b, c] : net.corners) {
    twice += cross(net.vertices[b] - net.vertices[a], net.vertices[c] - net.vertices[a]);
  }
  return 0.5 * twice;
}

struct Plan {
  SheetLayout layout;
  std::vector<Turn> turns;
};

Plan make_plan(std::span<const Net> nets, const std::vector<std::vector<Turn>>& turns,
               const Size& sheet, const SheetOptions& options) {
  const Size room = {sheet.width - 2 * options.margin, sheet.height - 2 * options.margin};
  if (room.width <= 0 || room.height <= 0) {
    throw InputError("bad-margin",
                     "margins leave nothing of the sheet: paper and margin do not fit");
  }
  Plan plan;
  plan.layout.scale = common_scale(turns, room);
  std::vector<Size> boxes;
  double area = 0;
  for (std::size_t i = 0; i < nets.size(); ++i) {
    plan.turns.push_back(choose_turn(turns[i], plan.layout.scale, room));
    const Size& box = plan.turns.back().box;
    boxes.push_back({plan.layout.scale * box.width, plan.layout.scale * box.height});
    area += plan.layout.scale * plan.layout.scale * net_area(nets[i]);
  }
  plan.layout.sheet_width = sheet.width;
  plan.layout.sheet_height = sheet.height;
  plan.layout.placements = place_in_rows(boxes, {sheet, room}, options, plan.layout.sheet_count);
  plan.layout.efficiency = area / (sheet.width * sheet.height * plan.layout.sheet_count);
  return plan;
}

bool better(const Plan& a, const Plan& b) {
  if (a.layout.sheet_count != b.layout.sheet_count) {
    return a.layout.sheet_count < b.layout.sheet_count;
  }
  return a.layout.scale > b.layout.scale * (1 + 1e-6);
}

/// Turns and scales a net, its box from (0, 0).
void transform(Net& net, const Turn& turn, double scale) {
  Vec2 low(1e300, 1e300);
  for (Vec2& p : net.vertices) {
    p = scale * Vec2(turn.c * p.x() - turn.s * p.y(), turn.s * p.x() + turn.c * p.y());
    low = low.cwiseMin(p);
  }
  for (Vec2& p : net.vertices) p -= low;
}

}  // namespace

SheetLayout lay_on_sheets(std::span<Net> nets, const SheetOptions& options) {
  std::vector<std::vector<Turn>> turns;
  for (const Net& net : nets) turns.push_back(make_turns(net));
  const Size portrait = {options.width, options.height};
  const Size landscape = {options.height, options.width};
  std::optional<Plan> best;
  if (options.orientation != Orientation::kLandscape) {
    best = make_plan(nets, turns, portrait, options);
  }
  if (options.orientation != Orientation::kPortrait) {
    Plan plan = make_plan(nets, turns, landscape, options);
    if (!best || better(plan, *best)) best = std::move(plan);
  }
  for (std::size_t i = 0; i < nets.size(); ++i) {
    transform(nets[i], best->turns[i], best->layout.scale);
  }
  return best->layout;
}

}  // namespace foldwright
