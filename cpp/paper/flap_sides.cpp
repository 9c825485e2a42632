#include "paper/flap_sides.h"

#include <algorithm>
#include <limits>

namespace foldwright {
namespace {

// What a lower flap than the other side's costs, by its share of a full one.
constexpr double kLower = 0.6;

/// What it costs to have the flap of a seam on a side.
double loss(const SideHeights& heights, int side, double full) {
  if (heights[side] < 0) return std::numeric_limits<double>::infinity();
  const double best = std::max(heights[0], heights[1]);
  if (best <= 0) return 0;
  if (heights[side] <= 0) return 1;
  return kLower * (best - heights[side]) / full;
}

/// The sides along one chain by their banks: the cheapest way through it.
std::vector<int> banks_of(const std::vector<SeamStep>& chain, std::span<const SideHeights> heights,
                          double full, double change) {
  const auto cost_at = [&](std::size_t i, int bank) {
    const auto& [seam, side] = chain[i];
    return loss(heights[seam], bank == 0 ? side : 1 - side, full);
  };
  std::vector<std::array<int, 2>> came_from(chain.size());
  std::array<double, 2> costs = {cost_at(0, 0), cost_at(0, 1)};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    std::array<double, 2> next;
    for (const int bank : {0, 1}) {
      const bool changes = costs[1 - bank] + change < costs[bank];
      came_from[i][bank] = changes ? 1 - bank : bank;
      next[bank] = (changes ? costs[1 - bank] + change : costs[bank]) + cost_at(i, bank);
    }
    costs = next;
  }
  std::vector<int> banks(chain.size());
  int bank = costs[1] < costs[0] ? 1 : 0;
  for (std::size_t i = chain.size(); i-- > 0;) {
    banks[i] = bank;
    if (i > 0) bank = came_from[i][bank];
  }
  return banks;
}

}  // namespace

std::vector<int> sides_in_chains(std::span<const std::vector<SeamStep>> chains,
                                 std::span<const SideHeights> heights, double full, double change) {
  std::vector<int> sides;
  for (const SideHeights& height : heights) sides.push_back(height[1] > height[0] ? 1 : 0);
  for (const std::vector<SeamStep>& chain : chains) {
    const std::vector<int> banks = banks_of(chain, heights, full, change);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      sides[chain[i].seam] = banks[i] == 0 ? chain[i].side : 1 - chain[i].side;
    }
  }
  return sides;
}

std::vector<int> sides_in_turn(std::span<const Net> nets, std::span<const Seam> seams) {
  std::vector<int> sides(seams.size(), -1);
  for (const std::vector<SeamStep>& steps : steps_along_outlines(nets, seams)) {
    bool here = true;
    for (const auto& [seam, side] : steps) {
      // A seam that another piece decided about sets the turn, too.
      if (sides[seam] == -1) sides[seam] = here ? side : 1 - side;
      here = sides[seam] != side;
    }
  }
  return sides;
}

}  // namespace foldwright
