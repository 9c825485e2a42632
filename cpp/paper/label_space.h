#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/box_grid.h"
#include "paper/flaps.h"
#include "paper/text_box.h"

namespace foldwright {

/// What is drawn on a net: lines, which texts keep off, and texts.
class LabelSpace {
 public:
  /// Folds however flat, cuts and the outlines of flaps count as lines; edges within a flat panel
  /// do not.
  LabelSpace(const Net& net, std::span<const Flap> flaps);

  /// Whether a text there touches no line and no other text.
  bool is_free(const TextBox& box) const;

  /// Whether a stroke stays on the paper and touches no text; it may cross folds.
  bool is_open(const Stroke& stroke) const;

  void take(const TextBox& box);
  /// Adds a line that texts keep off from now on.
  void take(const Stroke& stroke);

 private:
  struct Line {
    Stroke stroke;
    Box2 box;
    bool is_outline;
  };
  struct Text {
    TextBox box;
    std::array<Vec2, 4> corners;
    Box2 reach;  ///< around the corners
  };

  void add_line(const Stroke& stroke, bool is_outline);

  std::vector<Line> lines_;
  std::vector<Text> texts_;
  BoxGrid<2> line_grid_, text_grid_;
};

}  // namespace foldwright
