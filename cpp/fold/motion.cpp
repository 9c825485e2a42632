#include "fold/motion.h"

#include <algorithm>

namespace foldwright {

FoldMotion straight_motion(const FoldTree& folds) {
  return motion_over({std::vector<double>(folds.size(), 0), std::vector<double>(folds.size(), 1)});
}

FoldMotion motion_over(std::vector<std::vector<double>> shares) {
  FoldMotion motion;
  motion.kind = shares.size() == 2 ? Folding::kLine : Folding::kWaypoints;
  for (std::size_t key = 0; key < shares.size(); ++key) {
    motion.times.push_back(static_cast<double>(key) / static_cast<double>(shares.size() - 1));
  }
  motion.shares = std::move(shares);
  return motion;
}

std::vector<double> shares_at(const FoldMotion& motion, double time) {
  const auto after = std::upper_bound(motion.times.begin(), motion.times.end(), time);
  if (after == motion.times.end()) return motion.shares.back();
  const std::size_t key = static_cast<std::size_t>(after - motion.times.begin()) - 1;
  const double s = (time - motion.times[key]) / (motion.times[key + 1] - motion.times[key]);
  std::vector<double> shares;
  for (std::size_t fold = 0; fold < motion.shares[key].size(); ++fold) {
    shares.push_back((1 - s) * motion.shares[key][fold] + s * motion.shares[key + 1][fold]);
  }
  return shares;
}

}  // namespace foldwright
