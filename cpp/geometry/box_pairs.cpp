#include "geometry/box_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace foldwright {
namespace {

// Width of a column in mean boxes: narrow ones hold many boxes twice, wide ones compare many that
// are far from each other.
constexpr double kColumnWidth = 4;

/// Divides the space of some boxes into columns along its longest axis, counted in mean boxes.
template <int N>
class Columns {
 public:
  /// \pre there are boxes
  explicit Columns(std::span<const Box<N>> boxes) {
    Box<N> all = boxes[0];
    for (const Box<N>& box : boxes) all = all.joined(box);
    std::array<double, N> mean{};
    for (const Box<N>& box : boxes) {
      for (int i = 0; i < N; ++i) mean[i] += box.max[i] - box.min[i];
    }
    for (double& size : mean) size = std::max(size / static_cast<double>(boxes.size()), 1e-300);
    const auto length = [&](int axis) { return (all.max[axis] - all.min[axis]) / mean[axis]; };
    for (int axis = 1; axis < N; ++axis) {
      if (length(axis) > length(along_)) along_ = axis;
    }
    for (int axis = 0, i = 0; axis < N; ++axis) {
      if (axis == along_) continue;
      // No more than leave 16 boxes or more to each on average, however far a few of them lie.
      const double most = std::max(1.0, std::sqrt(static_cast<double>(boxes.size())) / 4);
      const double count = std::clamp(length(axis) / kColumnWidth, 1.0, most);
      across_[i] = axis;
      count_[i] = static_cast<int>(count);
      first_[i] = all.min[axis];
      per_column_[i] = count_[i] / std::max(all.max[axis] - all.min[axis], 1e-300);
      ++i;
    }
  }

  int along() const { return along_; }
  /// The other axes.
  int across(int i) const { return across_[i]; }
  int count() const {
    return std::accumulate(count_.begin(), count_.end(), 1, std::multiplies<>());
  }
  /// The column where a point is.
  int at(const std::array<double, N>& p) const { return index(place(p)); }
  /// Calls `visit(column)` for every column that the box reaches into.
  template <class Visit>
  void for_columns(const Box<N>& box, Visit&& visit) const {
    const Place first = place(box.min);
    const Place last = place(box.max);
    if constexpr (N == 2) {
      for (int a = first[0]; a <= last[0]; ++a) visit(a);
    } else {
      for (int b = first[1]; b <= last[1]; ++b) {
        for (int a = first[0]; a <= last[0]; ++a) visit(index({a, b}));
      }
    }
  }

 private:
  using Place = std::array<int, N - 1>;

  Place place(const std::array<double, N>& p) const {
    Place place;
    for (int i = 0; i < N - 1; ++i) {
      const double at = (p[across_[i]] - first_[i]) * per_column_[i];
      place[i] = std::clamp(static_cast<int>(at), 0, count_[i] - 1);
    }
    return place;
  }
  int index(const Place& place) const {
    if constexpr (N == 2) {
      return place[0];
    } else {
      return place[1] * count_[0] + place[0];
    }
  }

  int along_ = 0;
  std::array<int, N - 1> across_, count_;
  std::array<double, N - 1> first_, per_column_;
};

/// A box in a column.
template <int N>
struct Member {
  double from, to;  ///< along the column
  Box<N - 1> across;
  int box;
};

/// Calls `visit(i, j)` for every pair, until it returns false.
template <int N, class Visit>
void sweep(std::span<const Box<N>> boxes, Visit&& visit) {
  if (boxes.empty()) return;
  const Columns<N> columns(boxes);
  const int along = columns.along();

  std::vector<std::pair<double, int>> order;
  order.reserve(boxes.size());
  for (const Box<N>& box : boxes) {
    order.emplace_back(box.min[along], static_cast<int>(order.size()));
  }
  std::sort(order.begin(), order.end());

  // Counting sort of the boxes into the columns, where they stay in that order.
  std::vector<int> first(static_cast<std::size_t>(columns.count()) + 1, 0);
  for (const Box<N>& box : boxes) columns.for_columns(box, [&](int c) { ++first[c + 1]; });
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  std::vector<Member<N>> members(first.back());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (const auto& [from, i] : order) {
    const Box<N>& box = boxes[i];
    Member<N> member{from, box.max[along], {}, i};
    for (int k = 0; k < N - 1; ++k) {
      member.across.min[k] = box.min[columns.across(k)];
      member.across.max[k] = box.max[columns.across(k)];
    }
    columns.for_columns(box, [&](int c) { members[next[c]++] = member; });
  }

  for (int column = 0; column < columns.count(); ++column) {
    const Member<N>* const end = members.data() + first[column + 1];
    for (const Member<N>* a = members.data() + first[column]; a != end; ++a) {
      for (const Member<N>* b = a + 1; b != end && b->from < a->to; ++b) {
        if (a->from >= b->to || !a->across.meets(b->across)) continue;
        // Boxes may share columns; the pair counts in that of their intersection's lower corner.
        std::array<double, N> corner{};
        for (int k = 0; k < N - 1; ++k) {
          corner[columns.across(k)] = std::max(a->across.min[k], b->across.min[k]);
        }
        if (columns.at(corner) != column) continue;
        if (!visit(std::min(a->box, b->box), std::max(a->box, b->box))) return;
      }
    }
  }
}

}  // namespace

template <int N>
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box<N>> boxes) {
  std::vector<std::array<int, 2>> pairs;
  sweep(boxes, [&](int i, int j) {
    pairs.push_back({i, j});
    return true;
  });
  return pairs;
}

void visit_meeting_boxes(std::span<const Box3> boxes, const std::function<bool(int, int)>& visit) {
  sweep(boxes, visit);
}

template std::vector<std::array<int, 2>> meeting_boxes<2>(std::span<const Box2> boxes);
template std::vector<std::array<int, 2>> meeting_boxes<3>(std::span<const Box3> boxes);

}  // namespace foldwright
