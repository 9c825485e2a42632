#pragma once

#include <array>
#include <string>

#include "geometry/vec.h"

namespace foldwright {

/// Height of capitals and digits over the size of their font.
inline constexpr double kCapHeight = 0.72;

/// Width of a text over the size of its font, at most: no common sans-serif face is wider.
double text_width(const std::string& text);

/// A straight stroke.
struct Stroke {
  Vec2 from, to;
};

/// The box of a text and what is kept free around it, turned.
struct TextBox {
  Vec2 centre, along;  ///< `along`: unit vector in the direction of reading
  double half_width, half_height;

  Vec2 up() const { return {-along.y(), along.x()}; }
  /// Counter-clockwise from the lower left.
  std::array<Vec2, 4> corners() const;
};

/// How large a text is and what is kept free around it; mm.
struct Lettering {
  double size;  ///< of the font
  double clearance = 0;
};

/// The box of a text around its centre.
TextBox box_around(const std::string& text, const Lettering& letters, const Vec2& centre,
                   const Vec2& along);

/// Where the straight way from the middle of a box to a point leaves the box; the point itself if
/// it is inside.
Vec2 exit_of(const TextBox& box, const Vec2& towards);

/// Whether a stroke has a point within a box.
bool meets(const TextBox& box, const Stroke& stroke);

/// Whether two strokes cross, or touch.
bool crosses(const Stroke& a, const Stroke& b);

}  // namespace foldwright
