#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/vec.h"

namespace foldwright {

/// A closed surface, wound counter-clockwise as seen from outside; its hollows belong to it.
struct Solid {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
};

/// The surface of several solids together.
struct UnitedSolids {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  /// Per face the one that it is all or a share of, counted through all solids in a row.
  std::vector<int> sources;
};

/// Unites solids: no value where it cannot. The host brings one along, of a library for exact
/// booleans; the engine has none of its own. What it makes must depend on nothing but the solids.
using SolidUniter = std::function<std::optional<UnitedSolids>(const std::vector<Solid>&)>;

}  // namespace foldwright
