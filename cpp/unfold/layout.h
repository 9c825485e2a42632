#pragma once

#include <array>
#include <span>
#include <vector>

#include "unfold/spanning_tree.h"

namespace foldwright {

/// Faces overlap when their interiors do by more than this share of the mean edge length: above the
/// rounding that a chain of thousands of motions piles up, below anything scissors can tell.
inline constexpr double kOverlapTolerance = 1e-7;

/// Where each panel lies in the plane: the motion from its own coordinates.
using Layout = std::vector<RigidMotion2>;

/// Lays a fold tree flat; the root keeps its own coordinates [paper, 3.1]. Linear.
Layout lay_out(const DualGraph& graph, const RootedTree& tree);

/// All pairs of panels (a, b), a < b, that overlap in a layout, sorted [paper, 4.1.2].
std::vector<std::array<int, 2>> overlapping_panels(const DualGraph& graph, const Layout& layout);

/// The triangle moved to its place.
inline Triangle2 moved(const RigidMotion2& motion, const Triangle2& t) {
  return {motion(t[0]), motion(t[1]), motion(t[2])};
}

}  // namespace foldwright
