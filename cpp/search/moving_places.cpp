#include "search/moving_places.h"

#include <algorithm>

namespace foldwright {
namespace {

// Faces that are usually looked at beside one that moves, at most.
constexpr std::int64_t kUsualVisits = 64;

// Faces beyond these that cost as much as moving another face: large ones nearly all meet its box.
constexpr std::int64_t kVisitsOfFace = 16;

}  // namespace

bool FlatSpace::collide(const Face& a, const Face& b) const {
  return triangles_overlap(a, b, kOverlapTolerance * graph->unit);
}

std::vector<RigidMotion2> FlatSpace::lay_out(const RootedTree& tree) const {
  return foldwright::lay_out(*graph, tree);
}

std::vector<std::array<int, 2>> FlatSpace::collisions(
    const RootedTree&, const std::vector<RigidMotion2>& places) const {
  return overlapping_panels(*graph, places);
}

FoldedSpace::FoldedSpace(const Foldable& foldable, double share)
    : foldable_(&foldable), share_(share), tolerance_(kTouching * foldable.graph->unit) {
  for (const Triangle2& face : foldable.faces) faces_.push_back(moved(RigidMotion3{}, face));
  const DualGraph& graph = *foldable.graph;
  for (int h = 0; h < graph.hinge_count(); ++h) {
    const Hinge& hinge = graph.hinges[h];
    beside_.push_back(fold_beside(foldable, h, hinge.panels[1], share * hinge.angle));
  }
}

std::vector<RigidMotion3> FoldedSpace::lay_out(const RootedTree& tree) const {
  return fold_up(*foldable_, tree, fold_angles(*foldable_->graph, share_));
}

std::vector<std::array<int, 2>> FoldedSpace::collisions(
    const RootedTree& tree, const std::vector<RigidMotion3>& places) const {
  return colliding_panels(*foldable_, tree, places);
}

template <class Space>
MovingPlaces<Space>::MovingPlaces(const DualGraph& graph, Space space, const RootedTree& tree)
    : graph_(&graph),
      space_(std::move(space)),
      places_(space_.lay_out(tree)),
      panel_of_(graph.triangles.size()),
      faces_(graph.triangles.size()),
      boxes_(graph.triangles.size()),
      grid_(static_cast<int>(graph.triangles.size()), mean_box_size()),
      partners_(graph.panel_count()),
      conflict_slot_(graph.panel_count(), -1),
      seen_(graph.triangles.size(), 0) {
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      panel_of_[i] = panel;
      faces_[i] = space_.placed(places_[panel], space_.face(i));
      boxes_[i] = space_.box(faces_[i]);
      grid_.insert(i, boxes_[i]);
    }
  }
  for (const auto& [a, b] : space_.collisions(tree, places_)) add_collision(a, b);
}

template <class Space>
double MovingPlaces<Space>::mean_box_size() const {
  double sum = 0;
  for (std::size_t i = 0; i < graph_->triangles.size(); ++i) {
    const Box2 box = box_of(graph_->triangles[i]);
    sum += (box.max[0] - box.min[0]) + (box.max[1] - box.min[1]);
  }
  return 0.5 * sum / static_cast<double>(graph_->triangles.size());
}

template <class Space>
void MovingPlaces<Space>::add_collision(int a, int b) {
  for (const auto& [panel, partner] : {std::array{a, b}, std::array{b, a}}) {
    if (partners_[panel].empty()) {
      conflict_slot_[panel] = static_cast<int>(conflicted_.size());
      conflicted_.push_back(panel);
    }
    partners_[panel].push_back(partner);
  }
  ++collision_count_;
}

template <class Space>
void MovingPlaces<Space>::forget_partner(int panel, int partner) {
  std::vector<int>& list = partners_[panel];
  *std::find(list.begin(), list.end(), partner) = list.back();
  list.pop_back();
  if (!list.empty()) return;
  const int last = conflicted_.back();
  conflicted_[conflict_slot_[panel]] = last;
  conflict_slot_[last] = conflict_slot_[panel];
  conflicted_.pop_back();
}

template <class Space>
void MovingPlaces<Space>::remove_collision(int a, int b) {
  forget_partner(a, b);
  forget_partner(b, a);
  --collision_count_;
}

template <class Space>
int MovingPlaces<Space>::crossing(const MovingTree& tree) const {
  int crossing = 0;
  if (collision_count_ == 0) return crossing;
  for (const int panel : tree.selected()) {
    for (const int partner : partners_[panel]) crossing += tree.moves(partner) ? 0 : 1;
  }
  return crossing;
}

template <class Space>
int MovingPlaces<Space>::try_join(MovingTree& tree, int join, double limit) {
  const auto [hung, onto] = tree.ends(join);
  trial_.hung = hung;
  trial_.onto = onto;
  trial_.motion = places_[onto] * space_.beside(join, hung) * places_[hung].inverse();
  trial_.collisions.clear();
  trial_.panels = trial_.faces = trial_.visits = 0;
  for (std::size_t i = 0; i < tree.selected().size(); ++i) {
    if (!count_panel(tree, tree.listed(i), limit)) break;
  }
  return static_cast<int>(trial_.collisions.size());
}

template <class Space>
bool MovingPlaces<Space>::count_panel(const MovingTree& tree, int panel, double limit) {
  const auto first_of_panel = static_cast<std::ptrdiff_t>(trial_.collisions.size());
  ++trial_.panels;
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    const Face face = space_.placed(trial_.motion, faces_[i]);
    const Box<kDimensions> box = space_.box(face);
    ++query_;
    ++trial_.faces;
    bool within = true;
    grid_.visit(box, [&](int other) {
      ++trial_.visits;
      if (seen_[other] == query_) return true;
      seen_[other] = query_;
      const int partner = panel_of_[other];
      if (tree.moves(partner) || !box.meets(boxes_[other])) return true;
      if (Space::kSparesJoined && panel == trial_.hung && partner == trial_.onto) return true;
      if (!space_.collide(face, faces_[other])) return true;
      // Panels of several faces may meet more than once.
      const std::array<int, 2> pair = {panel, partner};
      if (std::find(trial_.collisions.begin() + first_of_panel, trial_.collisions.end(), pair) !=
          trial_.collisions.end()) {
        return true;
      }
      trial_.collisions.push_back(pair);
      within = static_cast<double>(trial_.collisions.size()) <= limit;
      return within;
    });
    if (!within) return false;
  }
  return true;
}

template <class Space>
std::int64_t MovingPlaces<Space>::trial_excess() const {
  const std::int64_t unusual = trial_.visits - kUsualVisits * trial_.faces;
  return trial_.faces - trial_.panels + std::max<std::int64_t>(0, unusual) / kVisitsOfFace;
}

template <class Space>
void MovingPlaces<Space>::accept(const MovingTree& tree) {
  for (const int panel : tree.selected()) {
    // Backwards, because removing replaces an entry by the last one.
    for (auto i = static_cast<int>(partners_[panel].size()) - 1; i >= 0; --i) {
      const int partner = partners_[panel][i];
      if (!tree.moves(partner)) remove_collision(panel, partner);
    }
  }
  for (const auto& [panel, partner] : trial_.collisions) add_collision(panel, partner);
  for (const int panel : tree.selected()) move_panel(panel, trial_.motion * places_[panel]);
}

template <class Space>
void MovingPlaces<Space>::move_panel(int panel, const Motion& place) {
  places_[panel] = place;
  for (int i = graph_->first_face[panel]; i < graph_->first_face[panel + 1]; ++i) {
    grid_.remove(i, boxes_[i]);
    faces_[i] = space_.placed(place, space_.face(i));
    boxes_[i] = space_.box(faces_[i]);
    grid_.insert(i, boxes_[i]);
  }
}

template class MovingPlaces<FlatSpace>;
template class MovingPlaces<FoldedSpace>;

}  // namespace foldwright
