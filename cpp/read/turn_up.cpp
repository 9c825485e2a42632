#include "read/turn_up.h"

namespace foldwright {

void turn_up(std::span<Vec3> positions, Axis up) {
  if (up == Axis::kY) return;
  for (Vec3& p : positions) {
    // Taken from 0, for a 0 shall not become a -0.
    p = up == Axis::kZ ? Vec3(p.x(), p.z(), 0 - p.y()) : Vec3(0 - p.y(), p.x(), p.z());
  }
}

}  // namespace foldwright
