#pragma once

#include <vector>

#include "geometry/box_grid.h"
#include "paper/craft_sides.h"
#include "paper/silhouette.h"
#include "unfold/tree_cost.h"

namespace foldwright {

/// What makes a net good to craft, in shares of a missing flap.
struct CraftWeights {
  double flaps = 1;    ///< per cut edge that has no room for one
  double hull = 3;     ///< per area of the faces that the convex hull has
  double necks = 0.5;  ///< per fold too short to hold what hangs at it
  double excess = 1;   ///< per mm that sticks out of the sheet
  double glue = 0.2;   ///< per length of cuts within the piece over the root of its area
};

struct CraftOptions {
  double scale = 1;  ///< millimetres per model unit
  FlapShape shape = {};
  CraftWeights weights = {};
  Extent room;  ///< that the piece should fit, mm
  /// Edges at the border of the piece that want a flap, with what there is on their other side.
  std::vector<BorderRoom> borders;
};

/// The cost of a net on paper: cut edges without room for a flap, a large hull, weak necks, what
/// sticks out of the sheet, and how much there is to glue.
///
/// Room is measured as flaps are placed (`room_profile.h`), but with no flap in the way of another;
/// only edges over 4 mm count, each by its better side.
class CraftCost : public TreeCost {
 public:
  /// Mesh and graph must outlive this object.
  CraftCost(const Mesh& mesh, const DualGraph& graph, const CraftOptions& options);

  void lay(const FoldTree& folds, const Layout& places) override;
  double cost() const override { return total(now_); }
  double try_swap(const TreeSwap& swap, double limit) override;
  void accept() override;
  int worst_cut(Random& random) const override;
  std::int64_t work() const override { return work_; }

  /// Height of the flap that each border edge has room for on this piece, by mesh edge.
  std::vector<BorderRoom> border_rooms();

 private:
  struct Terms {
    double flaps = 0, hull = 0;
    int necks = 0;
    double excess = 0;
    double glue = 0;  ///< mm
  };
  struct Placed {
    Triangle2 face;
    Box2 box;
  };

  static constexpr double kUnknown = -1;

  double total(const Terms& terms) const;
  double seam_cost(double height) const;
  bool is_cut(int side) const;
  Box2 reach_of(const CraftSide& side, const Triangle2& face) const;
  void put(int slot, Placed placed);
  void forget_trial();
  void touch(int seam);
  void touch_side(int side);
  void find_stale();
  void touch_near(int slot, const Box2& around, const Placed& placed, bool in_trial);
  void measure_seams(double limit);
  double best_height(const CraftSeam& seam);
  /// Height of the flap that a side has room for as faces lie in the trial.
  double measure(int side);
  void take_measures();
  int count_necks() const;
  void measure_shape(Terms& terms) const;

  const DualGraph* graph_;
  CraftOptions options_;
  FlapShape probe_;  ///< what room is measured with: also less than a flap
  CraftSides cuts_;
  double area_ = 0;  ///< of the faces, mm^2

  std::vector<char> is_fold_;
  std::vector<Placed> placed_;  ///< per face
  BoxGrid<2> grid_;
  std::vector<Box2> reach_;   ///< per side: around where its flap may lie
  std::vector<double> room_;  ///< per side; kUnknown where it does not matter
  std::vector<double> cost_;  ///< per seam
  Terms now_;

  // The trial under way:
  TreeSwap trial_{};
  std::vector<char> moves_;  ///< per face
  std::vector<int> moved_slots_;
  std::vector<Placed> trial_placed_;  ///< per face; of those that move
  std::vector<char> is_stale_;        ///< per side: its surroundings change
  std::vector<int> stale_sides_, stale_seams_;
  std::vector<std::pair<int, double>> new_rooms_, new_costs_;
  Terms then_;
  std::int64_t work_ = 0;

  std::vector<std::uint32_t> seen_;  ///< per face, within one query
  std::uint32_t query_ = 0;
  RoomProfile profile_{};
};

}  // namespace foldwright
