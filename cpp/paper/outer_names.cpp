#include "paper/outer_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/convex2.h"

namespace foldwright {
namespace {

// As large as can be; below 2 mm a text is hard to read.
constexpr double kSizes[] = {3.5, 2.5, 2};

// How far a name may be away from its piece, in turn; mm. The least leaves the line to see.
constexpr double kAways[] = {1, 1.5, 2, 3, 5, 8};

// What may be in the way of a name: as far as it can be away from its piece, and a long one.
constexpr double kReach = 60;

// What stays free between a name and whatever else there is, mm.
constexpr double kClearance = 0.4;

// Between the places that are tried, mm.
constexpr double kStep = 0.5;

std::array<Vec2, 4> corners_of(const Vec2& centre, const Vec2& half) {
  return {centre - half, centre + Vec2(half.x(), -half.y()), centre + half,
          centre + Vec2(-half.x(), half.y())};
}

Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double share = square == 0 ? 0 : std::clamp(along.dot(p - a) / square, 0.0, 1.0);
  return a + share * along;
}

class OuterNames {
 public:
  explicit OuterNames(const OuterNameTask& task) : task_(task) {}

  /// The name of a piece as a label in the coordinates of the piece.
  std::optional<Label> write(int piece) {
    const Surroundings around = task_.sheets.around(piece, kReach);
    for (const double size : kSizes) {
      const TextBox text = box_around(task_.names[piece], {size}, Vec2::Zero(), Vec2::UnitX());
      const Vec2 half(text.half_width, text.half_height);
      for (const double away : kAways) {
        const auto found = find(around, piece, half, away);
        if (!found) continue;
        task_.sheets.take(piece, {*found, Vec2::UnitX(), half.x(), half.y()});
        return Label{
            task_.names[piece], *found, 0, size, leader_from(around, piece, *found, half), true};
      }
    }
    return std::nullopt;
  }

 private:
  /// The first place from the upper left where a text reaches its piece only if it grows by `away`,
  /// and nothing else by then.
  static std::optional<Vec2> find(const Surroundings& around, int piece, const Vec2& half,
                                  double away) {
    const Box2 own = box_of_piece(around, piece).grown(away);
    const Vec2 least(around.paper.min[0], around.paper.min[1]);
    const Vec2 most(around.paper.max[0], around.paper.max[1]);
    const Vec2 low = (Vec2(own.min[0], own.min[1]) - half).cwiseMax(least + half);
    const Vec2 high = (Vec2(own.max[0], own.max[1]) + half).cwiseMin(most - half);
    const Box2 reach = box_of(std::array<Vec2, 2>{low - half, high + half}).grown(away);
    std::vector<const Obstacle*> near;
    for (const Obstacle& obstacle : around.obstacles) {
      if (obstacle.box.meets(reach)) near.push_back(&obstacle);
    }
    for (double y = high.y(); y >= low.y(); y -= kStep) {
      for (double x = low.x(); x <= high.x(); x += kStep) {
        if (is_place({x, y}, half, away, piece, near)) return Vec2(x, y);
      }
    }
    return std::nullopt;
  }

  static bool is_place(const Vec2& centre, const Vec2& half, double away, int piece,
                       std::span<const Obstacle* const> near) {
    const auto reach = [&](double margin) {
      return corners_of(centre, half + Vec2(margin, margin));
    };
    const std::array<Vec2, 4> close = reach(kClearance);
    const std::array<Vec2, 4> far = reach(away);
    const Box2 box = box_of(far);
    bool touches_own = false;
    for (const Obstacle* obstacle : near) {
      if (!obstacle->box.meets(box)) continue;
      if (convex_overlap(close, obstacle->polygon, 0)) return false;
      touches_own |= obstacle->piece == piece && convex_overlap(far, obstacle->polygon, 0);
    }
    return touches_own;
  }

  static Box2 box_of_piece(const Surroundings& around, int piece) {
    std::vector<Vec2> points;
    for (const Obstacle& obstacle : around.obstacles) {
      if (obstacle.piece != piece) continue;
      points.insert(points.end(), obstacle.polygon.begin(), obstacle.polygon.end());
    }
    return box_of(points);
  }

  /// From the box of a text straight to the nearest point of its piece.
  static Stroke leader_from(const Surroundings& around, int piece, const Vec2& centre,
                            const Vec2& half) {
    Stroke best = {centre, centre};
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Vec2& from, const Vec2& to) {
      const double length = (to - from).norm();
      if (length >= least) return;
      least = length;
      best = {from, to};
    };
    const std::array<Vec2, 4> box = corners_of(centre, half);
    for (const Obstacle& obstacle : around.obstacles) {
      if (obstacle.piece != piece) continue;
      const std::vector<Vec2>& polygon = obstacle.polygon;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& next = polygon[(i + 1) % polygon.size()];
        for (std::size_t j = 0; j < box.size(); ++j) {
          const Vec2& side = box[(j + 1) % box.size()];
          consider(nearest_on(box[j], side, polygon[i]), polygon[i]);
          consider(box[j], nearest_on(polygon[i], next, box[j]));
        }
      }
    }
    return best;
  }

  OuterNameTask task_;
};

bool has_name(const std::vector<Label>& labels, const std::string& name) {
  return !labels.empty() && labels.front().text == name;
}

}  // namespace

void write_outer_names(const OuterNameTask& task, LabelPlan& plan) {
  OuterNames names(task);
  for (int i = 0; i < static_cast<int>(task.names.size()); ++i) {
    if (has_name(plan.labels[i], task.names[i])) continue;
    const auto label = names.write(i);
    if (label) plan.labels[i].insert(plan.labels[i].begin(), *label);
  }
}

}  // namespace foldwright
