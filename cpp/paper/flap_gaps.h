#pragma once

#include <optional>
#include <span>
#include <vector>

#include "paper/room_profile.h"
#include "paper/seams.h"

namespace foldwright {

/// Cuts that run side by side are one line or at least so far apart where that costs no flap, mm:
/// what lies between them is hard to cut out, and tears.
inline constexpr double kApart = 1;

/// What lies near a flap: convex, counter-clockwise polygons in the net's coordinates.
struct FlapNeighbours {
  std::vector<std::span<const Vec2>> faces;
  std::vector<std::span<const Vec2>> flaps;  ///< which may give way as well
};

/// The flap with its side at one end upon the line beside it, if that is nearer than 0.3 mm all
/// along: one cut serves both. None if there is no such line, or less than half of the top would be
/// left. Whether that place is free is not looked at. Linear in the neighbours' corners.
std::optional<Trapezoid> laid_on(const SeamSide& side, const Trapezoid& flap, int end,
                                 const FlapNeighbours& neighbours);

/// The flap with its side at one end drawn in as far as that takes it away from what is closer than
/// `kApart`; of the room between two flaps each leaves half. Its height stays, and two thirds of
/// its top. Linear in the neighbours' corners.
Trapezoid drawn_in(const SeamSide& side, const Trapezoid& flap, int end,
                   const FlapNeighbours& neighbours);

}  // namespace foldwright
