#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/box_grid.h"
#include "paper/room_profile.h"
#include "paper/seams.h"

namespace foldwright {

/// Why a cut edge has no flap.
enum class FlapMiss {
  kShort,   ///< the edge is too short for one
  kThin,    ///< the faces on both sides are too thin to hide one
  kNarrow,  ///< the faces beside it leave too narrow a wedge
  kBlocked  ///< other faces or flaps are in the way
};

/// Corners of a flap in the net's coordinates: foot, top, top, foot, counter-clockwise.
std::vector<Vec2> flap_corners(const SeamSide& side, const Trapezoid& flap);

/// The room that flaps have beside the edges of nets: it shrinks with every flap.
class FlapRoom {
 public:
  using Polygon = std::vector<Vec2>;
  /// What flaps must not overlap.
  struct Obstacle {
    Polygon polygon;
    Box2 box;
  };

  /// `keep_off`: per net further convex polygons that flaps must not overlap; or empty. What is
  /// given must outlive this.
  FlapRoom(std::span<const Net> nets, std::span<const std::vector<Polygon>> keep_off);

  /// The highest flap of a shape that fits a side and lies within the cover, which is that of the
  /// panel beyond; none if not even the least does.
  std::optional<Trapezoid> best(const SeamSide& side, const FlapCover& cover,
                                const FlapShape& shape) const;

  /// What keeps a side from a flap, the first of the reasons in their order.
  /// \pre `best` finds none
  FlapMiss why_none(const SeamSide& side, const FlapCover& cover, const FlapShape& shape) const;

  /// A flap that was found, but takes up no room yet, with each of its sides upon what is beside it
  /// or away from it (see `kApart`).
  Trapezoid set_apart(const SeamSide& side, const FlapCover& cover, const Trapezoid& flap) const;

  /// Takes up the room of a flap; a number by which it can be given back.
  int take(const SeamSide& side, const Trapezoid& flap);
  void give_back(const SeamSide& side, int taken);

 private:
  /// Obstacles of one net: its faces, then all else.
  struct Obstacles {
    std::vector<Obstacle> all;
    BoxGrid<2> grid;
  };

  int add(int net, Polygon polygon);
  bool is_face(int net, const Obstacle* obstacle) const;
  std::vector<const Obstacle*> near(const SeamSide& side, double height) const;
  static std::optional<Trapezoid> best(const SeamSide& side, const FlapCover& cover,
                                       const FlapShape& shape,
                                       std::span<const Obstacle* const> obstacles);

  std::span<const Net> nets_;
  std::vector<Obstacles> obstacles_;  ///< per net
};

}  // namespace foldwright
