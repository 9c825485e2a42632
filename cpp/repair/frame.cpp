#include "repair/frame.h"

#include "mesh/input_error.h"

namespace foldwright {

Frame frame_of(std::span<const Vec3> positions) {
  // Volumes and squares of areas of what comes later stay in the range of doubles.
  constexpr double kSmallest = 1e-60;
  constexpr double kLargest = 1e60;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions) box.extend(p);
  const Vec3 half = 0.5 * box.max() - 0.5 * box.min();  // without overflow
  const double size = half.maxCoeff();
  if (size == 0) throw InputError("no-area", {{"what", "point"}});
  if (size < kSmallest || size > kLargest) {
    throw InputError("bad-size", {{"least", kSmallest}, {"most", kLargest}});
  }
  Frame frame{0.5 * box.max() + 0.5 * box.min(), 0, 0, 0};
  std::frexp(size, &frame.exponent);
  frame.diagonal = 2 * frame.scaled(frame.centre + half).norm();
  frame.longest = 2 * frame.scaled(size);
  return frame;
}

}  // namespace foldwright
