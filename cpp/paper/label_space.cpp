#include "paper/label_space.h"

#include "geometry/convex2.h"

namespace foldwright {
namespace {

// Cells about as large as texts.
constexpr double kTextCell = 3;

Box2 around(const Stroke& stroke) {
  // Lines along an axis have a box without inside, which meets nothing.
  return box_of(std::array{stroke.from, stroke.to}).grown(1e-9);
}

}  // namespace

LabelSpace::LabelSpace(const Net& net, std::span<const Flap> flaps)
    : line_grid_(static_cast<int>(net.edges.size()) + 1, kTextCell),
      text_grid_(static_cast<int>(net.edges.size()) + 1, kTextCell) {
  for (const Flap& flap : flaps) {
    for (int i = 0; i < 3; ++i) add_line({flap.corners[i], flap.corners[i + 1]}, true);
  }
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    const NetEdge& edge = net.edges[e];
    if (edge.assignment == Assignment::kFlat) continue;
    add_line({net.vertices[edge.vertices[0]], net.vertices[edge.vertices[1]]},
             edge.assignment == Assignment::kCut);
  }
}

bool LabelSpace::is_free(const TextBox& box) const {
  const auto corners = box.corners();
  const Box2 reach = box_of(corners);
  bool is_free = true;
  line_grid_.visit(reach, [&](int i) {
    is_free = !reach.meets(lines_[i].box) || !meets(box, lines_[i].stroke);
    return is_free;
  });
  if (!is_free) return false;
  text_grid_.visit(reach, [&](int i) {
    is_free = !reach.meets(texts_[i].reach) || !convex_overlap(corners, texts_[i].corners, 0);
    return is_free;
  });
  return is_free;
}

bool LabelSpace::is_open(const Stroke& stroke) const {
  const Box2 reach = around(stroke);
  bool is_open = true;
  line_grid_.visit(reach, [&](int i) {
    is_open = !lines_[i].is_outline || !crosses(stroke, lines_[i].stroke);
    return is_open;
  });
  if (!is_open) return false;
  text_grid_.visit(reach, [&](int i) {
    is_open = !meets(texts_[i].box, stroke);
    return is_open;
  });
  return is_open;
}

void LabelSpace::take(const TextBox& box) {
  const auto corners = box.corners();
  texts_.push_back({box, corners, box_of(corners)});
  text_grid_.insert(static_cast<int>(texts_.size()) - 1, texts_.back().reach);
}

void LabelSpace::take(const Stroke& stroke) { add_line(stroke, false); }

void LabelSpace::add_line(const Stroke& stroke, bool is_outline) {
  const Box2 box = around(stroke);
  lines_.push_back({stroke, box, is_outline});
  line_grid_.insert(static_cast<int>(lines_.size()) - 1, box);
}

}  // namespace foldwright
