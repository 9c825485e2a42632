#pragma once

#include <span>

#include "mesh/polygon_soup.h"

namespace foldwright {

/// Turns positions so that the axis `up` becomes y, which is up everywhere behind the readers.
///
/// A quarter turn about another axis: coordinates change places and signs, so that no bit is lost
/// and nothing is mirrored. With z up, x stays; with x up, z does.
void turn_up(std::span<Vec3> positions, Axis up);

}  // namespace foldwright
