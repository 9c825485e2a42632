#include "paper/labels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/convex2.h"
#include "paper/outline.h"
#include "paper/seams.h"

namespace foldwright {
namespace {

// The largest that fits is taken; below 2.5 mm (7 pt) a name is hard to find among the lines.
constexpr double kNameSizes[] = {6, 4.5, 3.5, 2.5};
// Ids are looked at from close by: 1.4 mm is 4 pt, the least that laser and inkjet printers render.
constexpr double kIdSizes[] = {3, 2.5, 2, 1.7, 1.4};

// Between a text and the middle of a line, of which half is 0.13 mm.
constexpr double kNameClearance = 0.7;
constexpr double kIdClearance = 0.3;

constexpr int kPlacesPerEdge = 9;

/// A text's box, turned.
struct TextBox {
  Vec2 centre, along;
  double half_width, half_height;

  Vec2 up() const { return {-along.y(), along.x()}; }
  std::array<Vec2, 4> corners() const {
    const Vec2 x = half_width * along;
    const Vec2 y = half_height * up();
    return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
  }
};

TextBox box_around(const std::string& text, double size, const Vec2& centre, const Vec2& along,
                   double clearance) {
  return {centre, along, 0.5 * text_width(text) * size + clearance,
          0.5 * kCapHeight * size + clearance};
}

struct Line {
  Vec2 from, to;
};

/// Whether a line has a point within a box (Liang and Barsky's clipping).
bool meets(const TextBox& box, const Line& line) {
  double enter = 0;
  double leave = 1;
  const auto clip = [&](const Vec2& axis, double half) {
    const double start = axis.dot(line.from - box.centre);
    const double step = axis.dot(line.to - line.from);
    if (std::abs(step) < 1e-12) return std::abs(start) < half;
    const double a = (-half - start) / step;
    const double b = (half - start) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    return enter < leave;
  };
  return clip(box.along, box.half_width) && clip(box.up(), box.half_height);
}

/// The texts of one net and the lines that they keep off.
class Writer {
 public:
  Writer(const Net& net, std::span<const Flap> flaps) {
    for (const NetEdge& edge : net.edges) {
      if (edge.assignment == Assignment::kFlat) continue;
      lines_.push_back({net.vertices[edge.vertices[0]], net.vertices[edge.vertices[1]]});
    }
    for (const Flap& flap : flaps) {
      for (int i = 0; i < 3; ++i) lines_.push_back({flap.corners[i], flap.corners[i + 1]});
    }
  }

  bool is_free(const TextBox& box) const {
    const auto corners = box.corners();
    const Box2 around = box_of(corners);
    for (const Line& line : lines_) {
      if (around.meets(box_of(std::array{line.from, line.to}).grown(1e-9)) && meets(box, line)) {
        return false;
      }
    }
    return std::ranges::none_of(taken_, [&](const std::array<Vec2, 4>& other) {
      return convex_overlap(corners, other, 0);
    });
  }

  void write(const std::string& text, double size, const TextBox& box) {
    taken_.push_back(box.corners());
    // Turned by half a turn where it would stand on its head; straight up reads from below.
    const bool is_upright = box.along.x() > 1e-9 || (box.along.x() > -1e-9 && box.along.y() > 0);
    const Vec2 along = is_upright ? box.along : -box.along;
    labels_.push_back({text, box.centre, std::atan2(along.y(), along.x()), size});
  }

  std::vector<Label> take() { return std::move(labels_); }

 private:
  std::vector<Line> lines_;
  std::vector<std::array<Vec2, 4>> taken_;
  std::vector<Label> labels_;
};

/// Where an id may go: in a band beside a base, from `from` in direction `along`.
struct Band {
  Vec2 from, along;
  Vec2 across;                        ///< unit vector away from the base
  double length;                      ///< of the base
  double depth;                       ///< of the band; 0: no end
  std::span<const Vec2> within = {};  ///< a convex polygon, counter-clockwise; empty: anywhere
};

/// Whether a box lies within a convex polygon, or there is none.
bool is_within(const TextBox& box, std::span<const Vec2> polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2 side = polygon[(i + 1) % polygon.size()] - a;
    const auto is_left = [&](const Vec2& p) { return cross(side, p - a) >= 0; };
    if (!std::ranges::all_of(box.corners(), is_left)) return false;
  }
  return true;
}

/// Writes a text in the band as large as it goes, near its middle, close to the base or in the
/// middle of a band of some depth.
bool write_in_band(Writer& writer, const Band& band, const std::string& text) {
  for (const double size : kIdSizes) {
    const double width = text_width(text) * size + 2 * kIdClearance;
    const double height = kCapHeight * size + 2 * kIdClearance;
    if (width > band.length || (band.depth > 0 && height > band.depth)) continue;
    const double away = band.depth > 0 ? 0.5 * band.depth : 0.5 * height + 1e-6;
    for (int i = 0; i < kPlacesPerEdge; ++i) {
      // From the middle to both ends in turn.
      const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
      const double shift = (band.length - width) * step / (kPlacesPerEdge - 1);
      const Vec2 centre = band.from + (0.5 * band.length + shift) * band.along + away * band.across;
      const TextBox box = box_around(text, size, centre, band.along, kIdClearance);
      // A narrow flap has no room beside its slanted sides, which a box need not touch.
      if (!is_within(box, band.within) || !writer.is_free(box)) continue;
      writer.write(text, size, box);
      return true;
    }
  }
  return false;
}

/// The name in a face, large rather than near the middle of the net.
void write_name(Writer& writer, const Net& net, const std::string& name) {
  Vec2 middle = Vec2::Zero();
  double total = 0;
  std::vector<Vec2> centres;
  for (const auto& [a, b, c] : net.corners) {
    const Vec2 p = net.vertices[a];
    const Vec2 q = net.vertices[b];
    const Vec2 r = net.vertices[c];
    const double area = 0.5 * cross(q - p, r - p);
    middle += area / 3 * (p + q + r);
    total += area;
    const Vec3 sides((r - q).norm(), (p - r).norm(), (q - p).norm());
    centres.push_back((sides[0] * p + sides[1] * q + sides[2] * r) / sides.sum());
  }
  middle /= total;
  std::vector<std::pair<double, int>> order;
  for (int i = 0; i < static_cast<int>(centres.size()); ++i) {
    order.emplace_back((centres[i] - middle).norm(), i);
  }
  std::sort(order.begin(), order.end());
  for (const double size : kNameSizes) {
    for (const auto& [distance, i] : order) {
      const TextBox box = box_around(name, size, centres[i], Vec2(1, 0), kNameClearance);
      if (!writer.is_free(box)) continue;
      writer.write(name, size, box);
      return;
    }
  }
}

Band inside_band(const SeamSide& side) {
  const Vec2 along = (side.to - side.from).normalized();
  return {side.from, along, Vec2(-along.y(), along.x()), side.length(), 0};
}

Band flap_band(const SeamSide& side, const Flap& flap) {
  const Vec2 along = (side.to - side.from).normalized();
  return {flap.corners[0],
          along,
          Vec2(along.y(), -along.x()),
          (flap.corners[3] - flap.corners[0]).norm(),
          flap.height,
          flap.corners};
}

/// Writes one side's id where it is wanted; false if it is nowhere.
bool write_id(Writer& writer, const SeamSide& side, const Flap* flap, IdPlace place,
              const std::vector<std::string>& texts) {
  const auto write = [&](const Band& band) {
    return std::ranges::any_of(
        texts, [&](const std::string& text) { return write_in_band(writer, band, text); });
  };
  const bool on_flap =
      place != IdPlace::kInside && flap != nullptr && write(flap_band(side, *flap));
  if (place == IdPlace::kFlap && on_flap) return true;
  return write(inside_band(side)) || on_flap;
}

/// Seams in the order of their numbers: along the outlines, piece by piece.
std::vector<int> numbered(std::span<const Net> nets, std::span<const Seam> seams) {
  std::map<std::pair<int, int>, int> seam_from;  // by net and the vertex that the edge starts from
  for (int i = 0; i < static_cast<int>(seams.size()); ++i) {
    for (const SeamSide& side : seams[i].sides) {
      seam_from[{side.net, nets[side.net].edges[side.edge].vertices[0]}] = i;
    }
  }
  std::vector<char> seen(seams.size(), 0);
  std::vector<int> order;
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (const std::vector<int>& walk : boundary_walks(nets[n])) {
      for (const int vertex : walk) {
        const auto seam = seam_from.find({n, vertex});
        if (seam == seam_from.end() || seen[seam->second]) continue;
        seen[seam->second] = 1;
        order.push_back(seam->second);
      }
    }
  }
  return order;
}

}  // namespace

std::string piece_letter(int index) {
  const std::string last(1, static_cast<char>('A' + index % 26));
  return index < 26 ? last : piece_letter(index / 26 - 1) + last;
}

double text_width(const std::string& text) {
  double width = 0;
  for (const char letter : text) {
    const bool is_digit = letter >= '0' && letter <= '9';
    width += is_digit ? 0.64 : letter == ':' ? 0.34 : 0.8;
  }
  return width;
}

LabelPlan place_labels(std::span<const Net> nets, std::span<const std::vector<Flap>> flaps,
                       IdPlace place) {
  std::vector<Writer> writers;
  for (std::size_t n = 0; n < nets.size(); ++n) {
    writers.emplace_back(nets[n], flaps[n]);
    write_name(writers[n], nets[n], piece_letter(static_cast<int>(n)));
  }
  LabelPlan plan;
  if (place != IdPlace::kNone) {
    const std::vector<Seam> seams = find_seams(nets);
    int number = 0;
    for (const int i : numbered(nets, seams)) {
      const std::string id = std::to_string(++number);
      bool is_complete = true;
      for (const int s : {0, 1}) {
        const SeamSide& side = seams[i].sides[s];
        const int other = seams[i].sides[1 - s].net;
        std::vector<std::string> texts = {id};
        if (other != side.net) texts.insert(texts.begin(), piece_letter(other) + ":" + id);
        const auto flap = std::ranges::find(flaps[side.net], side.edge, &Flap::edge);
        const bool has_flap = flap != flaps[side.net].end();
        is_complete &= write_id(writers[side.net], side, has_flap ? &*flap : nullptr, place, texts);
      }
      if (is_complete) {
        ++plan.printed;
      } else {
        plan.skipped.push_back(number);
      }
    }
  }
  for (Writer& writer : writers) plan.labels.push_back(writer.take());
  return plan;
}

}  // namespace foldwright
