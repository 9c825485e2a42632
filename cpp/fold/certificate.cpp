#include "fold/certificate.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_pairs.h"

namespace foldwright {
namespace {

// Slices to start from, per radian that the folds between the root and the farthest panel turn: a
// coarser cut leaves too many pairs to the halving, a finer one lays the net out too often.
constexpr double kSlicesPerRadian = 5;
constexpr int kFewestSlices = 16;
constexpr int kMostSlices = 2000;

// Halvings of a slice: true distances of a ten-thousandth of an edge exist.
constexpr int kDeepest = 22;

// So many counterexamples are enough to go on searching with, and nearer ones tell the same.
constexpr std::size_t kEnoughCounterexamples = 4;
constexpr double kApartInTime = 0.03;

// Shapes that are looked at before anything is proved, since that is far cheaper; closer together
// towards the end, where most motions fail.
constexpr int kGlances = 32;

// Added to every bound, in mean edge lengths: far above rounding, far below any clearance.
constexpr double kSlack = 1e-9;

/// What a face covers along an axis.
struct Shadow {
  double low, high;
};

using Along = std::array<double, 3>;  ///< places of a face's corners along an axis

Along along(const Vec3& axis, const Triangle3& face) {
  return {axis.dot(face[0]), axis.dot(face[1]), axis.dot(face[2])};
}

/// Of the corners, and so far on their ways.
Shadow shadow(const Along& at, const Along& way, double so_far) {
  const double p = at[0] + so_far * way[0];
  const double q = at[1] + so_far * way[1];
  const double r = at[2] + so_far * way[2];
  return {std::min(std::min(p, q), r), std::max(std::max(p, q), r)};
}

Shadow shadow(const Along& at) {
  return {std::min(std::min(at[0], at[1]), at[2]), std::max(std::max(at[0], at[1]), at[2])};
}

template <int N, class Triangle>
Box<N> box_of_all(std::span<const Triangle> triangles) {
  Box<N> all = box_of(triangles[0]);
  for (const Triangle& triangle : triangles) all = all.joined(box_of(triangle));
  return all;
}

}  // namespace

Leg straight_leg(const DualGraph& graph) {
  return {std::vector<double>(graph.hinges.size(), 0), fold_angles(graph, 1)};
}

Certificate::Certificate(const Foldable& foldable, std::span<const int> folds, Leg leg)
    : foldable_(&foldable),
      graph_(foldable.graph),
      tree_(hang_tree(*graph_, folds, tree_centre(*graph_, folds))),
      leg_(std::move(leg)),
      depth_(graph_->panel_count(), 0),
      rank_(graph_->panel_count(), 0),
      chain_(graph_->panel_count(), 0),
      rates_(graph_->panel_count(), 0),
      turning_(graph_->panel_count(), 0),
      bending_(graph_->panel_count(), 0),
      length_(graph_->panel_count(), 0),
      places_(graph_->panel_count()),
      twists_(graph_->panel_count()),
      faces_(graph_->faces.size()),
      is_needed_(graph_->panel_count(), 0) {
  for (int panel = 0; panel < graph_->panel_count(); ++panel) {
    panel_of_.insert(panel_of_.end(), graph_->panel_faces(panel).size(), panel);
  }
  measure_panels();
  find_chains();
  const double most = *std::max_element(turning_.begin(), turning_.end());
  slices_ =
      static_cast<int>(std::clamp<double>(kSlicesPerRadian * most, kFewestSlices, kMostSlices));
}

void Certificate::measure_panels() {
  for (std::size_t i = 0; i < tree_.order.size(); ++i) {
    const int panel = tree_.order[i];
    const double diameter = box_of_all<2>(graph_->panel_triangles(panel)).diagonal();
    longest_ = std::max(longest_, diameter);
    length_[panel] = diameter;
    rank_[panel] = static_cast<int>(i);
    const int parent = tree_.parent[panel];
    if (parent == -1) continue;
    const int hinge = tree_.hinge[panel];
    const double rate = leg_.to[hinge] - leg_.from[hinge];
    // Turning forwards about its axis takes the hinge's second panel down; see `fold_beside`.
    rates_[panel] = graph_->hinges[hinge].panels[1] == panel ? -rate : rate;
    depth_[panel] = depth_[parent] + 1;
    turning_[panel] = turning_[parent] + std::abs(rate);
    bending_[panel] =
        bending_[parent] + std::abs(rate) * (3 * turning_[panel] - 2 * std::abs(rate));
    length_[panel] += length_[parent];
  }
}

Certificate::State Certificate::step(std::int64_t work) {
  while (state_ == State::kRunning && work > 0) {
    if (!stack_.empty()) {
      work -= halve();
    } else if (glances_ < kGlances && counterexamples_.size() < kEnoughCounterexamples) {
      work -= glance();
    } else if (!counterexamples_.empty()) {
      state_ = State::kRefuted;
    } else if (slices_done_ < slices_) {
      work -= begin_slice();
    } else {
      state_ = State::kCertified;
    }
  }
  return state_;
}

/// Looks whether faces meet at one sampled shape.
int Certificate::glance() {
  const double u = (glances_++ + 0.5) / kGlances;
  const double s = 1 - u * u;
  const auto near = [s](double t) { return std::abs(s - t) < kApartInTime; };
  if (std::any_of(counterexamples_.begin(), counterexamples_.end(), near)) return 1;
  for (const int panel : tree_.order) place(panel, s);
  if (!colliding_panels(*foldable_, tree_, places_).empty()) counterexamples_.push_back(s);
  return static_cast<int>(faces_.size());
}

/// Looks at the next slice as a whole; late ones come first, since most motions fail late.
int Certificate::begin_slice() {
  const double r = 0.5 / slices_;
  const double s = 1 - (2 * slices_done_ + 1) * r;
  ++slices_done_;
  for (const int panel : tree_.order) place(panel, s);
  bound_extent(r);
  std::vector<Pair> open;
  const std::vector<Pair> pairs = near_pairs(r);
  for (const Pair& pair : pairs) {
    const Verdict verdict = judge(pair, r);
    if (verdict == Verdict::kApart) continue;
    open.push_back(pair);
    if (verdict == Verdict::kUndecided) continue;
    refute(s);
    open.clear();
    break;
  }
  push_halves({s, r, 0, {}}, std::move(open));
  return static_cast<int>(faces_.size() + pairs.size() / 4);
}

/// Pairs of faces whose boxes, as they are swept while every fold turns for `r`, meet.
std::vector<Certificate::Pair> Certificate::near_pairs(double r) const {
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const int panel = panel_of_[i];
    const double error = 0.5 * r * r * curving(panel, tree_.order[0]);
    Box3 box = box_of(faces_[i]);
    for (const Vec3& corner : faces_[i]) {
      const Vec3 way = r * twists_[panel].at(corner);
      for (int k = 0; k < 3; ++k) {
        box.min[k] = std::min(box.min[k], corner[k] - std::abs(way[k]));
        box.max[k] = std::max(box.max[k], corner[k] + std::abs(way[k]));
      }
    }
    boxes.push_back(box.grown(error + kSlack * graph_->unit));
  }
  std::vector<Pair> pairs;
  for (const auto& [i, j] : meeting_boxes(boxes)) {
    const int a = panel_of_[i];
    const int b = panel_of_[j];
    if (a == b || tree_.parent[a] == b || tree_.parent[b] == a) continue;
    pairs.push_back({i, j, meeting_panel(a, b)});
  }
  return pairs;
}

/// Cuts the tree into chains, each panel with the child that most panels hang from: any way to the
/// root meets few of them.
void Certificate::find_chains() {
  std::vector<int> below(graph_->panel_count(), 1);
  std::vector<int> heaviest(graph_->panel_count(), -1);
  for (std::size_t i = tree_.order.size(); i-- > 1;) {
    const int panel = tree_.order[i];
    const int parent = tree_.parent[panel];
    below[parent] += below[panel];
    int& heavy = heaviest[parent];
    if (heavy == -1 || below[panel] > below[heavy]) heavy = panel;
  }
  for (const int panel : tree_.order) {
    const int parent = tree_.parent[panel];
    chain_[panel] = parent != -1 && heaviest[parent] == panel ? chain_[parent] : panel;
  }
}

int Certificate::meeting_panel(int a, int b) const {
  while (chain_[a] != chain_[b]) {
    int& lower = depth_[chain_[a]] >= depth_[chain_[b]] ? a : b;
    lower = tree_.parent[chain_[lower]];
  }
  return depth_[a] <= depth_[b] ? a : b;
}

/// Bounds how far apart two points of the net are while every fold turns for `r`: a distance grows
/// no faster than by the turning of the folds at its two ends times the extent itself.
void Certificate::bound_extent(double r) {
  // Faces are eroded; hinges and corners lie within the largest panel's diameter of them.
  const double now = box_of_all<3>(std::span<const Triangle3>(faces_)).diagonal() + 2 * longest_;
  const double most = *std::max_element(turning_.begin(), turning_.end());
  extent_ = now * std::exp(2 * most * r);
}

/// Bound of the acceleration of a panel's points, seen from panel `frame` above it.
///
/// With folds 1..m on the way down that turn at rates w_k about axes at most D from the point, the
/// second derivative of its place is a sum over pairs of folds, at most
/// D sum_k |w_k| (2 W_(k-1) + W_k), where W_k = |w_1| + .. + |w_k|.
double Certificate::curving(int panel, int frame) const {
  const double turning = turning_[panel] - turning_[frame];
  const double bending = bending_[panel] - bending_[frame] - 3 * turning_[frame] * turning;
  const double reach = std::min(extent_, length_[panel] - length_[frame]);
  return std::max(0.0, bending) * reach;
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

int Certificate::place_some(double s, std::span<const Pair> pairs) {
  needed_.clear();
  for (const Pair& pair : pairs) {
    for (const int face : {pair.a, pair.b}) {
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
    const Vec3 turn = rates_[panel] * (frame.r * foldable_->axes[hinge]);
    const Vec3 point = frame(foldable_->points[hinge]);
    twists_[panel] = {twists_[parent].turn + turn, twists_[parent].shift + point.cross(turn)};
  }
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    faces_[i] = moved(places_[panel], foldable_->faces[i]);
  }
}

/// Whether two faces stay apart while every fold turns for `r`, seen from the panel where their
/// ways meet: when some direction separates them at both ends of the interval, as their velocities
/// take them there, by more than the error. In between they are apart by no less.
Certificate::Verdict Certificate::judge(const Pair& pair, double r) const {
  const int panel_a = panel_of_[pair.a];
  const int panel_b = panel_of_[pair.b];
  const Triangle3& a = faces_[pair.a];
  const Triangle3& b = faces_[pair.b];
  const double error = 0.5 * r * r * (curving(panel_a, pair.meet) + curving(panel_b, pair.meet)) +
                       kSlack * graph_->unit;
  const Twist& frame = twists_[pair.meet];
  // Relative to a corner, which keeps the rounding small far from the origin.
  Triangle3 at_a, at_b, way_a, way_b;
  for (int i = 0; i < 3; ++i) {
    at_a[i] = a[i] - a[0];
    at_b[i] = b[i] - a[0];
    way_a[i] = r * (twists_[panel_a].at(a[i]) - frame.at(a[i]));
    way_b[i] = r * (twists_[panel_b].at(b[i]) - frame.at(b[i]));
  }
  bool apart_now = false;
  bool apart_always = false;
  for_separating_axes(a, b, [&](const Vec3& axis) {
    const Along now_a = along(axis, at_a);
    const Along now_b = along(axis, at_b);
    // Most axes fail here.
    const Shadow a_now = shadow(now_a);
    const Shadow b_now = shadow(now_b);
    if (std::max(b_now.low - a_now.high, a_now.low - b_now.high) <= 0) return false;
    apart_now = true;
    const Along move_a = along(axis, way_a);
    const Along move_b = along(axis, way_b);
    const Shadow a_before = shadow(now_a, move_a, -1);
    const Shadow b_before = shadow(now_b, move_b, -1);
    const Shadow a_after = shadow(now_a, move_a, 1);
    const Shadow b_after = shadow(now_b, move_b, 1);
    const double least =
        std::max(std::min(b_before.low - a_before.high, b_after.low - a_after.high),
                 std::min(a_before.low - b_before.high, a_after.low - b_after.high));
    apart_always = least > 0 && least * least > error * error * axis.squaredNorm();
    return apart_always;
  });
  if (apart_always) return Verdict::kApart;
  return apart_now ? Verdict::kUndecided : Verdict::kMeet;
}

}  // namespace foldwright
