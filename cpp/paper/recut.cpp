#include "paper/recut.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace foldwright {
namespace {

// How many of the best cuts are followed up at each level: more found no fewer pieces on organic
// models at 300 mm.
constexpr std::array<int, 3> kBeam = {5, 3, 1};

// Nets of more plates would take seconds.
constexpr std::size_t kManyPlates = 250;

// Plates looked at before cuts are followed up no further: some tenths of a second. A net that
// falls into dozens of pieces would take minutes, and so far ahead nothing can be told.
constexpr std::int64_t kMostWork = 8'000'000;

// Pieces that a face too large for the room counts as: no cut helps there.
constexpr int kHopeless = 1000;

double area_of(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * twice;
}

/// How many rooms a piece of this hull takes up: 1 if it fits, and above that its box over the room
/// in each direction, at the best turn. No whole number, so that smaller counts as better.
double rooms_taken(std::span<const Vec2> hull, const Extent& room) {
  double least = std::numeric_limits<double>::infinity();
  for (const Turn& turn : upright_turns(hull)) {
    if (fits(turn.box, room)) return 1;
    const double across = std::max(1.0, turn.box.width / room.width);
    const double up = std::max(1.0, turn.box.height / room.height);
    least = std::min(least, across * up);
  }
  // What does not fit becomes two pieces at least.
  return 1 + least;
}

/// A cut and what it makes.
struct Cut {
  int fold;
  std::array<std::vector<int>, 2> halves;  ///< plates
  double rooms;                            ///< that the halves take up
  /// How uneven the halves are, and how much of their hulls they leave empty: both from 0 to 1.
  double untidiness;
};

class CutSearch {
 public:
  CutSearch(const Plates& plates, const Extent& room) : plates_(plates), room_(room) {
    folds_at_.resize(plates.corners.size());
    for (int f = 0; f < static_cast<int>(plates.folds.size()); ++f) {
      for (const int plate : plates.folds[f]) folds_at_[plate].push_back(f);
    }
  }

  /// The best cut of a piece that is no single plate, and the pieces that come of it.
  std::pair<int, int> best(const std::vector<int>& members, std::size_t level) {
    std::vector<Cut> cuts = cuts_of(members);
    const auto rank = [](const Cut& cut) {
      return std::tuple(cut.rooms, cut.untidiness, cut.fold);
    };
    const int width = level < kBeam.size() && work_ < kMostWork ? kBeam[level] : 1;
    const auto count = std::min<std::size_t>(width, cuts.size());
    std::ranges::partial_sort(cuts, cuts.begin() + static_cast<std::ptrdiff_t>(count), {}, rank);
    std::tuple<int, double, int> least;
    for (std::size_t i = 0; i < count; ++i) {
      // The halves of the first cut fit: no other makes fewer pieces or is tidier.
      if (i > 0 && cuts[0].rooms == 2) break;
      const int pieces =
          pieces_of(cuts[i].halves[0], level + 1) + pieces_of(cuts[i].halves[1], level + 1);
      const std::tuple found(pieces, cuts[i].untidiness, cuts[i].fold);
      if (i == 0 || found < least) least = found;
    }
    return {std::get<2>(least), std::get<0>(least)};
  }

  /// The first of the cuts alone, without looking further ahead.
  int tidiest(const std::vector<int>& members) {
    const std::vector<Cut> cuts = cuts_of(members);
    return std::ranges::min_element(
               cuts, {},
               [](const Cut& cut) { return std::tuple(cut.rooms, cut.untidiness, cut.fold); })
        ->fold;
  }

 private:
  int pieces_of(const std::vector<int>& members, std::size_t level) {
    const double rooms = rooms_taken(hull_of(members), room_);
    if (rooms == 1) return 1;
    if (members.size() == 1) return kHopeless;
    if (work_ >= kMostWork) return static_cast<int>(std::ceil(rooms));
    return best(members, level).second;
  }

  std::vector<Vec2> hull_of(const std::vector<int>& members) const {
    std::vector<Vec2> points;
    for (const int plate : members) {
      points.insert(points.end(), plates_.corners[plate].begin(), plates_.corners[plate].end());
    }
    return convex_hull(std::move(points));
  }

  std::vector<Cut> cuts_of(const std::vector<int>& members) {
    std::vector<char> is_member(plates_.corners.size(), 0);
    for (const int plate : members) is_member[plate] = 1;
    std::vector<Cut> cuts;
    for (int fold = 0; fold < static_cast<int>(plates_.folds.size()); ++fold) {
      const auto& [a, b] = plates_.folds[fold];
      if (is_member[a] && is_member[b]) cuts.push_back(cut_at(fold, members, is_member));
    }
    return cuts;
  }

  Cut cut_at(int fold, const std::vector<int>& members, const std::vector<char>& is_member) {
    work_ += static_cast<std::int64_t>(members.size());
    const int far = plates_.folds[fold][1];
    std::vector<char> is_far(plates_.corners.size(), 0);
    std::vector<int> open = {far};
    is_far[far] = 1;
    while (!open.empty()) {
      const int plate = open.back();
      open.pop_back();
      for (const int f : folds_at_[plate]) {
        const int next = plates_.folds[f][0] + plates_.folds[f][1] - plate;
        if (f == fold || !is_member[next] || is_far[next]) continue;
        is_far[next] = 1;
        open.push_back(next);
      }
    }
    Cut cut{fold, {}, 0, 0};
    for (const int plate : members) cut.halves[is_far[plate]].push_back(plate);
    std::array<double, 2> areas = {0, 0};
    double hulls = 0;
    for (const int half : {0, 1}) {
      const std::vector<Vec2> hull = hull_of(cut.halves[half]);
      cut.rooms += rooms_taken(hull, room_);
      hulls += area_of(hull);
      for (const int plate : cut.halves[half]) areas[half] += plates_.areas[plate];
    }
    const double area = areas[0] + areas[1];
    cut.untidiness = std::abs(areas[0] - areas[1]) / area + (1 - area / hulls);
    return cut;
  }

  const Plates& plates_;
  Extent room_;
  std::vector<std::vector<int>> folds_at_;  ///< per plate
  std::int64_t work_ = 0;                   ///< plates looked at
};

}  // namespace

int choose_cut(const Plates& plates, const Extent& room) {
  std::vector<int> all(plates.corners.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  CutSearch search(plates, room);
  return all.size() > kManyPlates ? search.tidiest(all) : search.best(all, 0).first;
}

}  // namespace foldwright
