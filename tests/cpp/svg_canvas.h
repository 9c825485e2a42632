#pragma once

#include <span>
#include <string>

#include "geometry/vec.h"

namespace foldwright::testing {

/// A colour of a picture, channels in [0, 1].
struct Colour {
  double red = 0, green = 0, blue = 0;

  Colour times(double light) const { return {red * light, green * light, blue * light}; }
};

/// One of 20 colours that are easy to tell apart, then again from the first. \pre part >= 0
Colour part_colour(int part);

/// From white at 0 through blue to black at 1.
Colour heat_colour(double value);

/// A rectangle of a picture, in px from its upper left corner.
struct PictureBox {
  double x = 0, y = 0, width = 0, height = 0;
};

enum class Anchor { kStart, kMiddle, kEnd };

/// A picture as SVG; what is drawn later covers what was drawn before.
class SvgCanvas {
 public:
  /// Size in px.
  SvgCanvas(double width, double height) : width_(width), height_(height) {}

  void rectangle(const PictureBox& box, const Colour& fill);
  /// A filled polygon, its outline in the same colour so that no gaps show between neighbours.
  void polygon(std::span<const Vec2> corners, const Colour& fill);
  void line(const Vec2& from, const Vec2& to, double width, const Colour& stroke);
  void text(const Vec2& at, double size, Anchor anchor, const std::string& words);

  std::string svg() const;

 private:
  double width_, height_;
  std::string body_;
};

}  // namespace foldwright::testing
