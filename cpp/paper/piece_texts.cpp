#include "paper/piece_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "paper/callouts.h"
#include "paper/label_space.h"
#include "paper/outer_ids.h"

namespace foldwright {
namespace {

// The largest that fits is taken; below 2.5 mm (7 pt) a name is hard to find among the lines.
constexpr double kNameSizes[] = {6, 4.5, 3.5, 2.5};
// Ids are looked at from close by. Of 2 mm and more they are easy to read.
constexpr double kEasySizes[] = {3, 2.5, 2};
// 1.4 mm is 4 pt, the least that laser and inkjet printers render.
constexpr double kSmallSizes[] = {1.7, 1.4};
constexpr double kLeastId = 1.4;
// Where a line leads to the edge larger ones would be in the way of others.
constexpr double kEasyLed[] = {2};

// Between a text and the middle of a line, of which half is 0.13 mm.
constexpr double kNameClearance = 0.7;
constexpr double kIdClearance = 0.25;

constexpr int kPlacesPerEdge = 9;

// How far a text may move away from its edge, in steps, and still seem to belong to it; mm.
constexpr double kAways[] = {0, 0.4, 0.8};

// Sides of seams that are served in a step: a few milliseconds.
constexpr int kSidesPerStep = 100;

// So far from its edge, in mm, a face has begun.
constexpr double kOffBase = 1e-3;

/// Where an id may go: in a band beside a base, from `from` in direction `along`.
struct Band {
  Vec2 from, along;
  Vec2 across;                        ///< unit vector away from the base
  double length;                      ///< of the base
  double depth;                       ///< of the band; 0: no end
  std::span<const Vec2> within = {};  ///< a convex polygon, counter-clockwise; empty: anywhere
};

/// A face, seen from one of its sides.
struct FaceSide {
  Vec2 from, along;  ///< `along`: unit vector; the face is on its left
  double length, height;
  double foot;  ///< of the opposite corner, along the side
};

/// The box of a text on a side of a face, where the face is widest at the height of the text; empty
/// if it does not go into the face.
std::optional<TextBox> box_on(const FaceSide& side, const std::string& text, double size,
                              double clearance) {
  TextBox box = box_around(text, {size, clearance}, side.from, side.along);
  const double share = 2 * box.half_height / side.height;
  if (2 * box.half_width > (1 - share) * side.length) return std::nullopt;
  const double middle = 0.5 * side.length + share * (side.foot - 0.5 * side.length);
  box.centre += middle * side.along + (box.half_height + 1e-6) * box.up();
  return box;
}

/// A face in which a name may stand.
struct NameFace {
  Vec2 centre;  ///< of the circle inside it
  std::array<FaceSide, 3> sides;
  double area;
};

NameFace name_face(const std::array<Vec2, 3>& corners) {
  NameFace face = {Vec2::Zero(), {}, 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0])};
  Vec3 lengths;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& from = corners[(i + 1) % 3];
    const Vec2 side = corners[(i + 2) % 3] - from;
    const double length = side.norm();
    const Vec2 along = side / length;
    face.sides[i] = {from, along, length, 2 * face.area / length, along.dot(corners[i] - from)};
    face.centre += length * corners[i];
    lengths[static_cast<int>(i)] = length;
  }
  face.centre /= lengths.sum();
  return face;
}

/// The faces of a net, those near its middle first.
std::vector<NameFace> faces_from_middle(const Net& net) {
  std::vector<NameFace> faces;
  Vec2 middle = Vec2::Zero();
  double total = 0;
  for (const auto& [a, b, c] : net.corners) {
    const std::array<Vec2, 3> corners = {net.vertices[a], net.vertices[b], net.vertices[c]};
    const NameFace& face = faces.emplace_back(name_face(corners));
    middle += face.area / 3 * (corners[0] + corners[1] + corners[2]);
    total += face.area;
  }
  middle /= total;
  const auto away = [&](const NameFace& face) { return (face.centre - middle).norm(); };
  std::ranges::stable_sort(faces, {}, away);
  return faces;
}

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

/// Finds places for texts on one net.
class Writer {
 public:
  Writer(const Net& net, std::span<const Flap> flaps)
      : space_(net, flaps), callouts_(net, kLeastId, kIdClearance) {}

  /// The name in a face, large rather than near the middle of the net; turned along a side of the
  /// face only where it has no room else.
  void write_name(const Net& net, const std::string& name);

  /// Writes a text in the band in the first of the sizes that fits, near its middle and close to
  /// the base.
  bool write_in_band(const Band& band, const std::string& text, std::span<const double> sizes) {
    return std::ranges::any_of(sizes, [&](double size) { return write_in_band(band, text, size); });
  }

  /// Writes apart from the edge, with a line that leads to it; false if there is no room.
  bool call_out(const SeamSide& side, const std::string& text, std::span<const double> sizes) {
    const auto found = callouts_.find(space_, side, text, sizes);
    if (!found) return false;
    write(text, found->size, found->box);
    space_.take(found->leader);
    labels_.back().leader = found->leader;
    return true;
  }

  /// Writes beside the net what does not fit on a flap: along the edge, or apart with a line that
  /// leads there.
  bool write_outside(const Stroke& edge, const std::string& text, OuterIdFinder& finder,
                     bool is_apart) {
    const auto found =
        is_apart ? finder.apart(edge, text, kEasyLed) : finder.beside(edge, text, kEasySizes);
    if (!found) return false;
    finder.take(found->box);
    write(text, found->size, found->box);
    if (is_apart) labels_.back().leader = found->leader;
    return true;
  }

  /// Keeps texts off a line.
  void keep_off(const Stroke& line) { space_.take(line); }

  std::size_t text_count() const { return labels_.size(); }
  std::vector<Label> take_labels() { return std::move(labels_); }
  std::vector<TextBox> take_boxes() { return std::move(boxes_); }

 private:
  bool write_if_free(const std::string& text, double size, const TextBox& box) {
    if (!space_.is_free(box)) return false;
    write(text, size, box);
    return true;
  }

  bool write_in_band(const Band& band, const std::string& text, double size) {
    const TextBox shape = box_around(text, {size, kIdClearance}, band.from, band.along);
    const double spare = band.length - 2 * shape.half_width;
    const double depth = 2 * shape.half_height;
    if (spare < 0 || (band.depth > 0 && depth > band.depth)) return false;
    for (const double further : kAways) {
      if (band.depth > 0 && depth + further > band.depth) break;
      for (int i = 0; i < kPlacesPerEdge; ++i) {
        // From the middle to both ends in turn.
        const int step = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
        const double x = 0.5 * band.length + spare * step / (kPlacesPerEdge - 1);
        const double y = shape.half_height + 1e-6 + further;
        TextBox box = shape;
        box.centre = band.from + x * band.along + y * band.across;
        // A narrow flap has no room beside its slanted sides, which a box need not touch.
        if (!is_within(box, band.within) || !space_.is_free(box)) continue;
        // Beyond a face that is thinner than the text is away there is no paper.
        const Vec2 base = band.from + x * band.along + kOffBase * band.across;
        if (band.within.empty() && !space_.is_open({base, box.centre})) continue;
        write(text, size, box);
        return true;
      }
    }
    return false;
  }

  void write(const std::string& text, double size, const TextBox& box) {
    space_.take(box);
    boxes_.push_back(box);
    // Turned by half a turn where it would stand on its head; straight up reads from below.
    const bool is_upright = box.along.x() > 1e-9 || (box.along.x() > -1e-9 && box.along.y() > 0);
    const Vec2 along = is_upright ? box.along : -box.along;
    labels_.push_back({text, box.centre, std::atan2(along.y(), along.x()), size});
  }

  LabelSpace space_;
  CalloutFinder callouts_;
  std::vector<Label> labels_;
  std::vector<TextBox> boxes_;  ///< of the labels
};

void Writer::write_name(const Net& net, const std::string& name) {
  const std::vector<NameFace> faces = faces_from_middle(net);
  for (const double size : kNameSizes) {
    for (const NameFace& face : faces) {
      const TextBox box = box_around(name, {size, kNameClearance}, face.centre, Vec2(1, 0));
      if (write_if_free(name, size, box)) return;
    }
  }
  for (const double size : kNameSizes) {
    for (const NameFace& face : faces) {
      for (const FaceSide& side : face.sides) {
        const auto box = box_on(side, name, size, kNameClearance);
        if (box && write_if_free(name, size, *box)) return;
      }
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

}  // namespace

class PieceWriter::Work {
 public:
  explicit Work(PieceTextTask task)
      : task_(std::move(task)),
        writer_(*task_.net, task_.flaps),
        is_written_(task_.ids.size(), 0),
        open_(task_.ids.size()) {
    std::iota(open_.begin(), open_.end(), 0);
    if (task_.place == IdPlace::kOutside) outer_.emplace(*task_.around);
  }

  bool step() {
    if (round_ == Round::kName) {
      for (const Stroke& line : task_.lines) writer_.keep_off(line);
      writer_.write_name(*task_.net, task_.name);
      round_ = task_.place == IdPlace::kOutside ? Round::kOutside : Round::kEasy;
      return task_.place == IdPlace::kNone;
    }
    for (int i = 0; i < kSidesPerStep && next_ < open_.size(); ++i) serve(open_[next_++]);
    if (next_ < open_.size()) return false;
    if (round_ == Round::kLedSmall) return true;
    // What found no place yet, once all else stands.
    round_ = round_after(round_);
    std::erase_if(open_, [&](int id) { return is_written_[id]; });
    next_ = 0;
    return open_.empty();
  }

  PieceTexts take() {
    std::vector<TextBox> boxes = writer_.take_boxes();
    std::vector<TextBox> outside;
    for (const std::size_t i : outside_) outside.push_back(boxes[i]);
    return {writer_.take_labels(), std::move(boxes), std::move(is_written_), std::move(outside)};
  }

 private:
  /// How texts are placed, one after the other: beside their edges or with a line that leads there,
  /// in sizes that are easy to read and in small ones. Where ids are to stand outside they go onto
  /// flaps and beside the net first, and onto faces only if there is no place.
  enum class Round { kName, kOutside, kLedOutside, kEasy, kLed, kSmall, kLedSmall };

  static Round round_after(Round round) { return static_cast<Round>(static_cast<int>(round) + 1); }

  void serve(int id) {
    const auto& [side, text] = task_.ids[id];
    if (round_ == Round::kOutside || round_ == Round::kLedOutside) {
      is_written_[id] = serve_outside(*side, text);
      return;
    }
    if (round_ == Round::kLed || round_ == Round::kLedSmall) {
      const auto sizes = round_ == Round::kLed ? std::span<const double>(kEasyLed) : kSmallSizes;
      is_written_[id] = writer_.call_out(*side, text, sizes);
      return;
    }
    const auto sizes = round_ == Round::kEasy ? std::span<const double>(kEasySizes) : kSmallSizes;
    const Flap* flap = flap_of(*side);
    const bool on_flap = flap && task_.place != IdPlace::kInside &&
                         writer_.write_in_band(flap_band(*side, *flap), text, sizes);
    const bool is_enough = on_flap && task_.place != IdPlace::kBoth;
    is_written_[id] =
        is_enough || writer_.write_in_band(inside_band(*side), text, sizes) || on_flap;
  }

  const Flap* flap_of(const SeamSide& side) const {
    const auto flap = std::ranges::lower_bound(task_.flaps, side.edge(), {}, &Flap::edge);
    return flap != task_.flaps.end() && flap->edge == side.edge() ? &*flap : nullptr;
  }

  bool serve_outside(const SeamSide& side, const std::string& text) {
    const Flap* flap = flap_of(side);
    const bool is_apart = round_ == Round::kLedOutside;
    if (flap && !is_apart) return writer_.write_in_band(flap_band(side, *flap), text, kEasySizes);
    const Stroke edge =
        flap ? Stroke{flap->corners[1], flap->corners[2]} : Stroke{side.from, side.to};
    if (!writer_.write_outside(edge, text, *outer_, is_apart)) return false;
    outside_.push_back(writer_.text_count() - 1);
    return true;
  }

  PieceTextTask task_;
  Writer writer_;
  std::optional<OuterIdFinder> outer_;  ///< of ids that are to stand outside
  std::vector<std::size_t> outside_;    ///< the texts that do
  std::vector<char> is_written_;
  std::vector<int> open_;  ///< ids that are to be served in this round
  std::size_t next_ = 0;   ///< of `open_`
  Round round_ = Round::kName;
};

PieceWriter::PieceWriter(PieceTextTask task) : work_(std::make_unique<Work>(std::move(task))) {}
PieceWriter::~PieceWriter() = default;
PieceWriter::PieceWriter(PieceWriter&&) noexcept = default;
PieceWriter& PieceWriter::operator=(PieceWriter&&) noexcept = default;
bool PieceWriter::step() { return work_->step(); }
PieceTexts PieceWriter::take() { return work_->take(); }

}  // namespace foldwright
