#pragma once

#include <optional>

#include "geometry/box_grid.h"
#include "paper/callouts.h"
#include "paper/sheet_obstacles.h"

namespace foldwright {

/// Finds places for the numbers of cut edges beside a piece, on what is cut off, so that none is
/// seen on the model.
class OuterIdFinder {
 public:
  /// `around` must outlive this.
  explicit OuterIdFinder(const Surroundings& around);

  /// Along an edge, which has the piece on its left, and as near to its middle as may be, for a
  /// text that is no longer than it. `sizes`: in the order in which they are tried, mm. The leader
  /// has no length.
  std::optional<Callout> beside(const Stroke& edge, const std::string& text,
                                std::span<const double> sizes) const;

  /// Within 12 mm of the edge's middle, with a line that leads there over nothing else.
  std::optional<Callout> apart(const Stroke& edge, const std::string& text,
                               std::span<const double> sizes) const;

  /// Keeps later texts off one.
  void take(const TextBox& text);

 private:
  bool is_free(const TextBox& text) const;
  bool is_open(const Stroke& leader) const;
  bool is_clear(std::span<const Vec2> polygon) const;

  const Surroundings& around_;
  std::vector<Obstacle> texts_;  ///< that were written since
  BoxGrid<2> grid_;              ///< of the obstacles, and behind them the texts
};

}  // namespace foldwright
