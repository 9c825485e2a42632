#include "paper/craft_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/convex2.h"
#include "paper/necks.h"

namespace foldwright {
namespace {

// Room below this height is no start of a flap.
constexpr double kLeastRoom = 1;

// What a cut edge costs by the height of the flap that it has room for, from the full one down:
// narrower ones hold, but glue less well; what is nearly a flap may become one.
constexpr double kAtFull = 0, kAtLeast = 0.5, kNearly = 1, kNone = 1.35;

RigidMotion2 scaled(RigidMotion2 motion, double scale) {
  motion.t *= scale;
  return motion;
}

double mean_reach(const DualGraph& graph, double scale, double height) {
  return scale * graph.unit + height;
}

}  // namespace

CraftCost::CraftCost(const Mesh& mesh, const DualGraph& graph, const CraftOptions& options)
    : graph_(&graph),
      options_(options),
      is_fold_(graph.hinge_count(), 0),
      grid_(static_cast<int>(graph.triangles.size()),
            mean_reach(graph, options.scale, options.shape.height)),
      moves_(graph.triangles.size(), 0) {
  probe_ = options_.shape;
  probe_.least = std::min(probe_.least, kLeastRoom);
  for (const double area : graph.areas) area_ += area * options_.scale * options_.scale;
  cuts_ = craft_sides(mesh, graph, {options_.scale, probe_, options_.borders});
  reach_.resize(cuts_.sides.size());
  room_.assign(cuts_.sides.size(), kUnknown);
  is_stale_.assign(cuts_.sides.size(), 0);
  cost_.assign(cuts_.seams.size(), 0);
  seen_.assign(graph.triangles.size(), 0);
}

double CraftCost::total(const Terms& terms) const {
  const CraftWeights& weights = options_.weights;
  return weights.flaps * terms.flaps + weights.hull * terms.hull / area_ +
         weights.necks * terms.necks + weights.excess * terms.excess +
         weights.glue * terms.glue / std::sqrt(area_);
}

double CraftCost::seam_cost(double height) const {
  const FlapShape& shape = options_.shape;
  if (height >= shape.height) return kAtFull;
  if (height >= shape.least) {
    return kAtLeast * (shape.height - height) / std::max(shape.height - shape.least, 1e-9);
  }
  return height >= kLeastRoom ? kNearly : kNone;
}

Box2 CraftCost::reach_of(const CraftSide& side, const Triangle2& face) const {
  const Vec2& from = face[side.corner];
  const Vec2 along = (face[(side.corner + 1) % 3] - from) / side.edge_length;
  const Vec2 to = from + side.length * along;
  const Vec2 out = options_.shape.height * Vec2(along.y(), -along.x());
  return box_of(std::array<Vec2, 4>{from, to, from + out, to + out});
}

void CraftCost::lay(const FoldTree& folds, const Layout& places) {
  const DualGraph& graph = *graph_;
  std::ranges::fill(is_fold_, 0);
  for (const int h : folds) is_fold_[h] = 1;
  for (std::size_t slot = 0; slot < placed_.size(); ++slot) {
    grid_.remove(static_cast<int>(slot), placed_[slot].box);
  }
  placed_.resize(graph.triangles.size());
  trial_placed_.resize(graph.triangles.size());
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const RigidMotion2 place = scaled(places[panel], options_.scale);
    for (int slot = graph.first_face[panel]; slot < graph.first_face[panel + 1]; ++slot) {
      Triangle2 face = graph.triangles[slot];
      for (Vec2& p : face) p *= options_.scale;
      put(slot, {moved(place, face), {}});
    }
  }
  forget_trial();
  for (std::size_t s = 0; s < cuts_.seams.size(); ++s) touch(static_cast<int>(s));
  now_ = {};
  now_.necks = count_necks();
  for (int h = 0; h < graph.hinge_count(); ++h) {
    if (!is_fold_[h]) now_.glue += graph.hinges[h].length * options_.scale;
  }
  measure_shape(now_);
  then_ = now_;
  std::ranges::fill(cost_, 0);
  new_rooms_.clear();
  new_costs_.clear();
  measure_seams(std::numeric_limits<double>::infinity());
  take_measures();
}

void CraftCost::put(int slot, Placed placed) {
  placed.box = box_of(placed.face);
  placed_[slot] = placed;
  grid_.insert(slot, placed.box);
  for (int s = cuts_.first_side[slot]; s < cuts_.first_side[slot + 1]; ++s) {
    reach_[s] = reach_of(cuts_.sides[s], placed.face);
  }
}

double CraftCost::try_swap(const TreeSwap& swap, double limit) {
  forget_trial();
  trial_ = swap;
  const RigidMotion2 motion = scaled(swap.motion, options_.scale);
  for (const int panel : swap.moved) {
    for (int slot = graph_->first_face[panel]; slot < graph_->first_face[panel + 1]; ++slot) {
      moves_[slot] = 1;
      moved_slots_.push_back(slot);
      Placed& placed = trial_placed_[slot];
      placed.face = moved(motion, placed_[slot].face);
      placed.box = box_of(placed.face);
    }
  }
  is_fold_[swap.cut] = 0;
  is_fold_[swap.join] = 1;
  then_ = now_;
  then_.necks = count_necks();
  then_.glue +=
      options_.scale * (graph_->hinges[swap.cut].length - graph_->hinges[swap.join].length);
  then_.hull = then_.excess = 0;
  measure_shape(then_);
  work_ = 1 + graph_->panel_count() / 25;
  if (total(then_) - now_.flaps * options_.weights.flaps <= limit) {
    find_stale();
    measure_seams(limit);
  }
  is_fold_[swap.cut] = 1;
  is_fold_[swap.join] = 0;
  return total(then_);
}

void CraftCost::forget_trial() {
  for (const int slot : moved_slots_) moves_[slot] = 0;
  moved_slots_.clear();
  for (const int side : stale_sides_) is_stale_[side] = 0;
  stale_sides_.clear();
  stale_seams_.clear();
  new_rooms_.clear();
  new_costs_.clear();
}

/// Notes a seam whose cost may change.
void CraftCost::touch(int seam) {
  for (const int side : cuts_.seams[seam].sides) {
    if (side != -1) touch_side(side);
  }
}

void CraftCost::touch_side(int side) {
  if (is_stale_[side]) return;
  is_stale_[side] = 1;
  stale_sides_.push_back(side);
  const CraftSeam& seam = cuts_.seams[cuts_.seam_of_side[side]];
  const int other = seam.sides[0] == side ? seam.sides[1] : seam.sides[0];
  if (other == -1 || !is_stale_[other]) stale_seams_.push_back(cuts_.seam_of_side[side]);
}

/// Sides whose surroundings change: what comes near to them or goes away lies on the other side of
/// the swap.
void CraftCost::find_stale() {
  const double reach = options_.shape.height;
  for (const int h : {trial_.cut, trial_.join}) {
    for (const int seam : cuts_.seams_of_hinge[h]) touch(seam);
  }
  for (const int slot : moved_slots_) {
    touch_near(slot, placed_[slot].box.grown(reach), placed_[slot], false);
    touch_near(slot, trial_placed_[slot].box.grown(reach), trial_placed_[slot], true);
  }
}

void CraftCost::touch_near(int slot, const Box2& around, const Placed& placed, bool in_trial) {
  ++query_;
  grid_.visit(around, [&](int other) {
    if (moves_[other] || seen_[other] == query_ || !around.meets(placed_[other].box)) return true;
    seen_[other] = query_;
    for (int s = cuts_.first_side[other]; s < cuts_.first_side[other + 1]; ++s) {
      if (is_cut(s) && reach_[s].meets(placed.box)) touch_side(s);
    }
    for (int s = cuts_.first_side[slot]; s < cuts_.first_side[slot + 1]; ++s) {
      if (!is_cut(s) || is_stale_[s]) continue;
      const Box2 box = in_trial ? reach_of(cuts_.sides[s], placed.face) : reach_[s];
      if (box.meets(placed_[other].box)) touch_side(s);
    }
    return true;
  });
}

bool CraftCost::is_cut(int side) const {
  const int hinge = cuts_.seams[cuts_.seam_of_side[side]].hinge;
  return hinge == -1 || !is_fold_[hinge];
}

void CraftCost::measure_seams(double limit) {
  for (const int seam : stale_seams_) then_.flaps -= cost_[seam];
  for (const int seam : stale_seams_) {
    const double cost =
        is_cut(cuts_.seams[seam].sides[0]) ? seam_cost(best_height(cuts_.seams[seam])) : 0;
    then_.flaps += cost;
    new_costs_.emplace_back(seam, cost);
    if (total(then_) > limit) return;
  }
}

/// Height of the flap that a seam has room for at its better side. A side is measured only where
/// the other one is not full.
double CraftCost::best_height(const CraftSeam& seam) {
  const double full = options_.shape.height;
  double best = seam.elsewhere;
  for (const int side : seam.sides) {
    if (side == -1) continue;
    if (is_stale_[side]) {
      new_rooms_.emplace_back(side, kUnknown);
    } else {
      best = std::max(best, room_[side]);
    }
  }
  for (const int side : seam.sides) {
    if (best >= full) break;
    if (side == -1 || (!is_stale_[side] && room_[side] != kUnknown)) continue;
    const double height = measure(side);
    new_rooms_.emplace_back(side, height);
    best = std::max(best, height);
  }
  return best;
}

double CraftCost::measure(int s) {
  const CraftSide& side = cuts_.sides[s];
  const Placed& own = moves_[side.slot] ? trial_placed_[side.slot] : placed_[side.slot];
  const Vec2& from = own.face[side.corner];
  const Vec2 along = (own.face[(side.corner + 1) % 3] - from) / side.edge_length;
  const Box2 reach = moves_[side.slot] ? reach_of(side, own.face) : reach_[s];
  bool is_open = true;
  const auto lower = [&](const Placed& obstacle) {
    Triangle2 local;
    double top = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec2 p = obstacle.face[i] - from;
      local[i] = {along.dot(p), cross(p, along)};
      top = std::max(top, local[i].y());
    }
    if (top < 1e-6) return;
    if (is_open) profile_ = open_room(side.length, probe_.height);
    is_open = false;
    lower_below(profile_, local);
  };
  ++query_;
  grid_.visit(reach, [&](int other) {
    if (other == side.slot || moves_[other] || seen_[other] == query_) return true;
    seen_[other] = query_;
    if (reach.meets(placed_[other].box)) lower(placed_[other]);
    return true;
  });
  for (const int other : moved_slots_) {
    if (other != side.slot && reach.meets(trial_placed_[other].box)) lower(trial_placed_[other]);
  }
  work_ += 1 + static_cast<std::int64_t>(moved_slots_.size()) / 100;
  if (is_open) return side.open;
  work_ += 2;
  lower_below(profile_, side.cover);
  const auto flap = best_flap(profile_, side.cover.lean, probe_);
  return flap ? flap->height : 0;
}

void CraftCost::accept() {
  is_fold_[trial_.cut] = 0;
  is_fold_[trial_.join] = 1;
  for (const int slot : moved_slots_) {
    grid_.remove(slot, placed_[slot].box);
    put(slot, trial_placed_[slot]);
  }
  take_measures();
}

void CraftCost::take_measures() {
  for (const auto& [side, room] : new_rooms_) room_[side] = room;
  for (const auto& [seam, cost] : new_costs_) cost_[seam] = cost;
  now_ = then_;
  forget_trial();
}

int CraftCost::count_necks() const {
  return static_cast<int>(find_necks(*graph_, is_fold_, options_.scale).size());
}

void CraftCost::measure_shape(Terms& terms) const {
  Silhouette silhouette;
  for (std::size_t slot = 0; slot < placed_.size(); ++slot) {
    for (const Vec2& p : (moves_[slot] ? trial_placed_[slot] : placed_[slot]).face) {
      silhouette.add(p);
    }
  }
  terms.hull = silhouette.area();
  terms.excess = options_.room.width > 0 ? silhouette.excess(options_.room) : 0;
}

int CraftCost::worst_cut(Random& random) const {
  // A few looks find one while there are many; when hardly any is left there is little to gain.
  for (int look = 0; look < 16 && !cuts_.seams.empty(); ++look) {
    const int seam = random.below(static_cast<int>(cuts_.seams.size()));
    if (cuts_.seams[seam].hinge != -1 && cost_[seam] > kAtLeast) return cuts_.seams[seam].hinge;
  }
  return -1;
}

std::vector<BorderRoom> CraftCost::border_rooms() {
  std::vector<BorderRoom> rooms;
  for (const CraftSeam& seam : cuts_.seams) {
    if (seam.hinge == -1) rooms.push_back({seam.mesh_edge, measure(seam.sides[0])});
  }
  std::ranges::sort(rooms, {}, &BorderRoom::mesh_edge);
  return rooms;
}

}  // namespace foldwright
