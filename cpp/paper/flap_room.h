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
  /// Where a flap may stand, with what lies around for good: several flaps are tried in one place.
  struct Site {
    const SeamSide* side;
    Box2 reach;               ///< around a flap of full height
    std::vector<int> fixed;   ///< obstacles near, but for the faces that it belongs to; ascending
    RoomProfile below_fixed;  ///< the room that these leave
  };

  /// `keep_off`: per net further convex polygons that flaps must not overlap; or empty. What is
  /// given must outlive this.
  FlapRoom(std::span<const Net> nets, std::span<const std::vector<Polygon>> keep_off);

  /// The site of flaps so high, at most, on a side that must outlive it.
  Site site_of(const SeamSide& side, double height) const;

  /// The highest flap of a shape that fits a site and lies within the cover, which is that of the
  /// panel beyond; none if not even the least does.
  /// \pre the shape is as high as the site was looked at for
  std::optional<Trapezoid> best(const Site& site, const FlapCover& cover,
                                const FlapShape& shape) const;

  /// What keeps a site from a flap, the first of the reasons in their order.
  /// \pre `best` finds none
  FlapMiss why_none(const Site& site, const FlapCover& cover, const FlapShape& shape) const;

  /// A flap that was found, but takes up no room yet, with each of its sides upon what is beside it
  /// or away from it (see `kApart`).
  Trapezoid set_apart(const Site& site, const FlapCover& cover, const Trapezoid& flap) const;

  /// Takes up the room of a flap; a number by which it can be given back.
  int take(const SeamSide& side, const Trapezoid& flap);
  void give_back(const SeamSide& side, int taken);

 private:
  struct Obstacles {
    std::vector<Obstacle> all;
    BoxGrid<2> grid;

    int add(Polygon polygon);
    /// Those whose boxes meet one, ascending.
    std::vector<int> near(const Box2& reach) const;
  };
  struct OfNet {
    Obstacles fixed;  ///< its faces, then what is to be kept off
    Obstacles taken;  ///< flaps
  };
  using Pointers = std::vector<const Obstacle*>;

  bool is_face(int net, int fixed) const;
  Pointers taken_near(const Site& site) const;
  Pointers fixed_near(const Site& site) const;

  std::span<const Net> nets_;
  std::vector<OfNet> obstacles_;  ///< per net
};

}  // namespace foldwright
