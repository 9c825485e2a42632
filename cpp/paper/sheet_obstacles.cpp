#include "paper/sheet_obstacles.h"

#include "geometry/convex2.h"

namespace foldwright {

SheetObstacles::SheetObstacles(std::span<const Footprint> pieces, const SheetLayout& layout,
                               const SheetOptions& options, std::span<const Strip> strips)
    : pieces_(pieces), layout_(layout), on_(layout.sheet_count) {
  const double low = ruled_margin(options);
  paper_ = {{low, low},
            {layout.sheet_width - options.margin, layout.sheet_height - options.margin}};
  for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
    const Placement& place = layout.placements[i];
    for (std::vector<Vec2> polygon : pieces[i].polygons) {
      for (Vec2& p : polygon) p += Vec2(place.x, place.y);
      add(place.sheet, std::move(polygon), i);
    }
  }
  for (const Strip& strip : strips) {
    add(strip.sheet, {strip.outline.begin(), strip.outline.end()}, -1);
  }
}

Surroundings SheetObstacles::around(int piece, double reach) const {
  const Placement& place = layout_.placements[piece];
  const Vec2 origin(place.x, place.y);
  const auto from_piece = [&](const Box2& box) -> Box2 {
    return {{box.min[0] - origin.x(), box.min[1] - origin.y()},
            {box.max[0] - origin.x(), box.max[1] - origin.y()}};
  };
  const Box2 near = box_of(pieces_[piece].points()).grown(reach);
  Surroundings found{{}, from_piece(paper_)};
  for (const Obstacle& obstacle : on_[place.sheet]) {
    const Box2 box = from_piece(obstacle.box);
    if (!box.meets(near)) continue;
    Obstacle& moved = found.obstacles.emplace_back(obstacle);
    moved.box = box;
    for (Vec2& p : moved.polygon) p -= origin;
  }
  return found;
}

void SheetObstacles::take(int piece, const TextBox& text) {
  const Placement& place = layout_.placements[piece];
  const auto corners = text.corners();
  std::vector<Vec2> polygon(corners.begin(), corners.end());
  for (Vec2& p : polygon) p += Vec2(place.x, place.y);
  add(place.sheet, std::move(polygon), -1);
}

void SheetObstacles::add(int sheet, std::vector<Vec2> polygon, int piece) {
  const Box2 box = box_of(polygon);
  on_[sheet].push_back({std::move(polygon), box, piece});
}

}  // namespace foldwright
