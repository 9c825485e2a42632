#pragma once

#include "geometry/triangle3.h"

namespace foldwright {

/// Whether two faces of a model of this extent run through each other by more than a touch: more
/// than a thousandth of the extent, or a tenth of the size of the smaller face. Faces in one plane
/// do not.
bool faces_cross(const Triangle3& a, const Triangle3& b, double extent);

/// Whether two such faces lie on each other: in one plane, with an area in common, both up to a
/// touch.
bool faces_overlap(const Triangle3& a, const Triangle3& b, double extent);

}  // namespace foldwright
