#include "fold/certificate.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_pairs.h"

namespace foldwright {
namespace {

// Intervals to start from: a coarser cut leaves too many pairs to the halving, a finer one lays the
// net out too often.
constexpr int kSlicesOfSmall = 64;
constexpr int kSlicesOfLarge = 128;
constexpr int kLarge = 600;  // faces

// Halvings of a slice: true distances of a ten-thousandth of an edge exist.
constexpr int kDeepest = 22;

// So many counterexamples are enough to go on searching with, and nearer ones tell the same.
constexpr std::size_t kEnoughCounterexamples = 4;
constexpr double kApartInTime = 0.03;

// Added to every bound, in mean edge lengths: far above rounding, far below any clearance.
constexpr double kSlack = 1e-9;

}  // namespace

Leg straight_leg(const DualGraph& graph) {
  return {std::vector<double>(graph.hinges.size(), 0), fold_angles(graph, 1)};
}

Certificate::Certificate(const Foldable& foldable, std::span<const int> folds, Leg leg)
    : foldable_(&foldable),
      graph_(foldable.graph),
      tree_(hang_tree(*graph_, folds, tree_centre(*graph_, folds))),
      leg_(std::move(leg)),
      slices_(static_cast<int>(graph_->faces.size()) < kLarge ? kSlicesOfSmall : kSlicesOfLarge),
      rates_(graph_->panel_count(), 0),
      depth_(graph_->panel_count(), 0),
      rank_(graph_->panel_count(), 0),
      places_(graph_->panel_count()),
      points_(graph_->panel_count()),
      axes_(graph_->panel_count()),
      faces_(graph_->faces.size()),
      centres_(graph_->faces.size()),
      is_needed_(graph_->panel_count(), 0) {
  for (int panel = 0; panel < graph_->panel_count(); ++panel) {
    for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
      const Triangle2& face = foldable.faces[i];
      const Vec2 centroid = (face[0] + face[1] + face[2]) / 3;
      panel_of_.push_back(panel);
      centroids_.push_back(centroid);
      radii_.push_back(std::max(
          {(face[0] - centroid).norm(), (face[1] - centroid).norm(), (face[2] - centroid).norm()}));
    }
  }
  for (std::size_t i = 1; i < tree_.order.size(); ++i) {
    const int panel = tree_.order[i];
    const int hinge = tree_.hinge[panel];
    rates_[panel] = std::abs(leg_.to[hinge] - leg_.from[hinge]);
    depth_[panel] = depth_[tree_.parent[panel]] + 1;
    rank_[panel] = static_cast<int>(i);
  }
}

Certificate::State Certificate::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    if (!stack_.empty()) {
      work -= halve();
    } else if (slices_done_ < slices_ && counterexamples_.size() < kEnoughCounterexamples) {
      work -= begin_slice();
    } else {
      state_ = counterexamples_.empty() ? State::kCertified : State::kRefuted;
    }
  }
  return state_;
}

/// Looks at the next slice as a whole; late ones come first, since most motions fail late.
int Certificate::begin_slice() {
  const double r = 0.5 / slices_;
  const double s = 1 - (2 * slices_done_ + 1) * r;
  ++slices_done_;
  const auto near = [s](double t) { return std::abs(s - t) < kApartInTime; };
  if (std::any_of(counterexamples_.begin(), counterexamples_.end(), near)) return 1;
  place_all(s);
  std::vector<Box3> boxes;
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const double reach = reach_to_root(static_cast<int>(face), r) + kSlack * graph_->unit;
    boxes.push_back(box_of(faces_[face]).grown(reach));
  }
  std::vector<Pair> open;
  int judged = 0;
  for (const Pair& pair : meeting_boxes(boxes)) {
    const int a = panel_of_[pair[0]];
    const int b = panel_of_[pair[1]];
    if (a == b || tree_.parent[a] == b || tree_.parent[b] == a) continue;
    ++judged;
    const Verdict verdict = judge(pair, r);
    if (verdict == Verdict::kMeet) {
      refute(s);
      return judged;
    }
    if (verdict == Verdict::kUndecided) open.push_back(pair);
  }
  push_halves({s, r, 0, {}}, std::move(open));
  return static_cast<int>(faces_.size()) + judged;
}

/// Looks at the open pairs of one half of an interval.
int Certificate::halve() {
  const Interval interval = std::move(stack_.back());
  stack_.pop_back();
  const int placed = place_some(interval.s, interval.pairs);
  std::vector<Pair> open;
  for (const Pair& pair : interval.pairs) {
    const Verdict verdict = judge(pair, interval.r);
    if (verdict == Verdict::kApart) continue;
    if (verdict == Verdict::kMeet || interval.depth == kDeepest) {
      refute(interval.s);
      return placed;
    }
    open.push_back(pair);
  }
  const int cost = (placed + static_cast<int>(interval.pairs.size())) / 2 + 1;
  push_halves(interval, std::move(open));
  return cost;
}

void Certificate::push_halves(const Interval& interval, std::vector<Pair> pairs) {
  if (pairs.empty()) return;
  const double r = interval.r / 2;
  stack_.push_back({interval.s - r, r, interval.depth + 1, pairs});
  stack_.push_back({interval.s + r, r, interval.depth + 1, std::move(pairs)});
}

void Certificate::refute(double s) {
  counterexamples_.push_back(s);
  stack_.clear();
}

void Certificate::place_all(double s) {
  for (const int panel : tree_.order) place(panel, s);
}

int Certificate::place_some(double s, std::span<const Pair> pairs) {
  needed_.clear();
  for (const Pair& pair : pairs) {
    for (const int face : pair) {
      for (int p = panel_of_[face]; p != -1 && !is_needed_[p]; p = tree_.parent[p]) {
        is_needed_[p] = 1;
        needed_.push_back(p);
      }
    }
  }
  std::sort(needed_.begin(), needed_.end(), [this](int a, int b) { return rank_[a] < rank_[b]; });
  for (const int panel : needed_) {
    is_needed_[panel] = 0;
    place(panel, s);
  }
  return static_cast<int>(needed_.size());
}

void Certificate::place(int panel, double s) {
  const int parent = tree_.parent[panel];
  if (parent != -1) {
    const int hinge = tree_.hinge[panel];
    const double angle = leg_.from[hinge] + s * (leg_.to[hinge] - leg_.from[hinge]);
    places_[panel] = places_[parent] * fold_beside(*foldable_, hinge, panel, angle);
    const RigidMotion3& frame = places_[graph_->hinges[hinge].panels[0]];
    points_[panel] = frame(foldable_->points[hinge]);
    axes_[panel] = frame.r * foldable_->axes[hinge];
  }
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    faces_[i] = moved(places_[panel], foldable_->faces[i]);
    centres_[i] = (faces_[i][0] + faces_[i][1] + faces_[i][2]) / 3;
  }
}

/// How far a face may move relative to the root while every fold turns for `r`.
double Certificate::reach_to_root(int face, double r) const {
  double reach = 0;
  for (int p = panel_of_[face]; tree_.parent[p] != -1; p = tree_.parent[p]) {
    const double distance = (centres_[face] - points_[p]).cross(axes_[p]).norm() + radii_[face];
    reach += r * rates_[p] * (distance + reach);
  }
  return reach;
}

/// How much nearer two faces may come while every fold turns for `r`.
///
/// Seen from between two folds of the path, face a moves by at most A and face b by at most B, each
/// summed from the face on: turning by q about an axis moves what is d away, and has moved by A, by
/// at most q (d + A). The best place to look from is taken.
double Certificate::relative_motion(int a, int b, double r) {
  path_.clear();
  up_b_.clear();
  int p = panel_of_[a];
  int q = panel_of_[b];
  while (p != q) {
    int& lower = depth_[p] >= depth_[q] ? p : q;
    (&lower == &p ? path_ : up_b_).push_back(lower);
    lower = tree_.parent[lower];
  }
  // Panels whose folds to their parents make the path from a to b.
  path_.insert(path_.end(), up_b_.rbegin(), up_b_.rend());

  const auto add_fold = [&](int panel, int face, double reach) {
    const double distance =
        (centres_[face] - points_[panel]).cross(axes_[panel]).norm() + radii_[face];
    return reach + r * rates_[panel] * (distance + reach);
  };
  reach_.assign(1, 0);
  for (const int panel : path_) reach_.push_back(add_fold(panel, a, reach_.back()));
  double least = reach_.back();
  double reach = 0;
  for (std::size_t k = path_.size(); k > 0; --k) {
    reach = add_fold(path_[k - 1], b, reach);
    least = std::min(least, reach_[k - 1] + reach);
  }
  return least;
}

Certificate::Verdict Certificate::judge(const Pair& pair, double r) {
  const auto [a, b] = pair;
  const double bound = relative_motion(a, b, r) + kSlack * graph_->unit;
  const double between = (centres_[a] - centres_[b]).norm() - radii_[a] - radii_[b];
  if (between > bound) return Verdict::kApart;
  const double gap = separation(faces_[a], faces_[b], bound);
  if (gap > bound) return Verdict::kApart;
  return gap > 0 ? Verdict::kUndecided : Verdict::kMeet;
}

}  // namespace foldwright
