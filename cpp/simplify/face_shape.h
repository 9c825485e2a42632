#pragma once

#include "geometry/triangle3.h"

namespace foldwright {

/// What a triangle's shape costs whoever folds it, in the unit of a quadric's sum (fourth power of
/// a length): thin ones have sharp corners, low ones cannot be scored. Nothing for a triangle that
/// is neither.
///
/// `usual`: the usual length of the mesh's edges. Thinness counts by the triangle's own size, so
/// that it weighs against the errors of its neighbourhood at any stage.
double shape_cost(const Triangle3& t, double usual);

/// Whether a triangle that takes the place of another one faces the same way, up to some 70
/// degrees, and has an area to do so with.
bool keeps_facing(const Triangle3& before, const Triangle3& after);

}  // namespace foldwright
