#include "paper/text_box.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace foldwright {
namespace {

/// Width of a character's first byte over the size of the font; of further bytes 0.
double byte_width(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  if (code >= 0x80) return code < 0xc0 ? 0 : 1.05;  // what is not ASCII may be as wide as high
  if (byte >= '0' && byte <= '9') return 0.64;
  if (byte == ':' || byte == ' ') return 0.34;
  if (std::string_view("MW@%mw").find(byte) != std::string_view::npos) return 1;
  return 0.8;
}

/// Whether something may hang below the baseline, or stand above capitals.
bool is_tall(char byte) {
  const bool is_capital = byte >= 'A' && byte <= 'Z';
  const bool is_digit = byte >= '0' && byte <= '9';
  return !is_capital && !is_digit && byte != ':' && byte != ' ';
}

}  // namespace

double text_width(const std::string& text) {
  double width = 0;
  for (const char byte : text) width += byte_width(byte);
  return width;
}

std::array<Vec2, 4> TextBox::corners() const {
  const Vec2 x = half_width * along;
  const Vec2 y = half_height * up();
  return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
}

TextBox box_around(const std::string& text, const Lettering& letters, const Vec2& centre,
                   const Vec2& along) {
  const auto& [size, clearance] = letters;
  const double height = std::ranges::any_of(text, is_tall) ? kCapHeight + 0.5 : kCapHeight;
  return {centre, along, 0.5 * text_width(text) * size + clearance,
          0.5 * height * size + clearance};
}

Vec2 exit_of(const TextBox& box, const Vec2& towards) {
  const Vec2 way = towards - box.centre;
  const double x = std::abs(way.dot(box.along)) / box.half_width;
  const double y = std::abs(way.dot(box.up())) / box.half_height;
  return box.centre + way / std::max({x, y, 1.0});
}

bool meets(const TextBox& box, const Stroke& stroke) {
  // Liang and Barsky's clipping, in the directions of the box.
  double enter = 0;
  double leave = 1;
  const auto clip = [&](const Vec2& axis, double half) {
    const double start = axis.dot(stroke.from - box.centre);
    const double step = axis.dot(stroke.to - stroke.from);
    const double end = start + step;
    // Most strokes lie on one side of it.
    if (std::min(start, end) >= half || std::max(start, end) <= -half) return false;
    if (std::abs(step) < 1e-12) return std::abs(start) < half;
    const double a = (-half - start) / step;
    const double b = (half - start) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    return enter < leave;
  };
  return clip(box.along, box.half_width) && clip(box.up(), box.half_height);
}

bool crosses(const Stroke& a, const Stroke& b) {
  const auto parts = [](const Stroke& s, const Stroke& t) {
    const double from = cross(s.to - s.from, t.from - s.from);
    const double to = cross(s.to - s.from, t.to - s.from);
    return from * to <= 0;
  };
  return parts(a, b) && parts(b, a);
}

}  // namespace foldwright
