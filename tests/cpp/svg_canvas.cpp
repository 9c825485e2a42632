#include "svg_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace foldwright::testing {
namespace {

constexpr Colour kPartColours[] = {
    {0.90, 0.36, 0.30}, {0.31, 0.60, 0.86}, {0.96, 0.75, 0.26}, {0.40, 0.72, 0.43},
    {0.65, 0.45, 0.80}, {0.95, 0.56, 0.25}, {0.33, 0.76, 0.76}, {0.91, 0.52, 0.70},
    {0.62, 0.74, 0.28}, {0.47, 0.48, 0.80}, {0.76, 0.55, 0.38}, {0.55, 0.82, 0.65},
    {0.80, 0.34, 0.52}, {0.55, 0.78, 0.93}, {0.78, 0.70, 0.88}, {0.60, 0.60, 0.60},
    {0.98, 0.87, 0.55}, {0.26, 0.52, 0.50}, {0.70, 0.30, 0.25}, {0.85, 0.85, 0.80}};

std::string hex(const Colour& colour) {
  const auto channel = [](double value) {
    return static_cast<unsigned>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", channel(colour.red), channel(colour.green),
                channel(colour.blue));
  return text;
}

/// A coordinate with a tenth of a px.
std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

Colour part_colour(int part) {
  return kPartColours[static_cast<std::size_t>(part) % std::size(kPartColours)];
}

Colour heat_colour(double value) {
  const double v = std::clamp(value, 0.0, 1.0);
  return {1 - std::min(1.0, 1.6 * v), 1 - v, 1 - std::max(0.0, 1.6 * v - 0.6)};
}

void SvgCanvas::rectangle(const PictureBox& box, const Colour& fill) {
  body_ += "<rect x=\"" + px(box.x) + "\" y=\"" + px(box.y) + "\" width=\"" + px(box.width) +
           "\" height=\"" + px(box.height) + "\" fill=\"" + hex(fill) + "\"/>\n";
}

void SvgCanvas::polygon(std::span<const Vec2> corners, const Colour& fill) {
  const std::string colour = hex(fill);
  body_ += "<polygon fill=\"" + colour + "\" stroke=\"" + colour +
           "\" stroke-width=\"0.5\" stroke-linejoin=\"round\" points=\"";
  for (const Vec2& corner : corners) body_ += px(corner.x()) + "," + px(corner.y()) + " ";
  body_ += "\"/>\n";
}

void SvgCanvas::line(const Vec2& from, const Vec2& to, double width, const Colour& stroke) {
  body_ += "<line x1=\"" + px(from.x()) + "\" y1=\"" + px(from.y()) + "\" x2=\"" + px(to.x()) +
           "\" y2=\"" + px(to.y()) + "\" stroke=\"" + hex(stroke) + "\" stroke-width=\"" +
           px(width) + "\" stroke-linecap=\"round\"/>\n";
}

void SvgCanvas::text(const Vec2& at, double size, Anchor anchor, const std::string& words) {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  body_ += "<text x=\"" + px(at.x()) + "\" y=\"" + px(at.y()) + "\" font-size=\"" + px(size) +
           "\" font-family=\"sans-serif\" text-anchor=\"" +
           kAnchors[static_cast<std::size_t>(anchor)] + "\">" + escaped(words) + "</text>\n";
}

std::string SvgCanvas::svg() const {
  const std::string width = px(width_), height = px(height_);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height +
         "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + body_ + "</svg>\n";
}

}  // namespace foldwright::testing
