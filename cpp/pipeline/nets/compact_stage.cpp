#include <algorithm>

#include "pipeline/nets/border_rooms.h"
#include "pipeline/nets/congruent_nets.h"
#include "pipeline/sheets/paper_plan.h"
#include "pipeline/sheets/recut_nets.h"
#include "pipeline/stage.h"

namespace foldwright {
namespace {

// Rounds over the nets: what a net gains at its border the others see in the next one.
constexpr int kRounds = 2;

// Work for a face, in about microseconds, and for a whole model: three seconds at most. Where a
// model has more faces than that allows for, its edges are too short for flaps at most sizes.
constexpr std::int64_t kWorkPerFace = 6000;
constexpr std::int64_t kMostWork = 3000000;

// What glue costs for bodies of polygons (see `CraftWeights::glue`): a long wall that is glued
// instead of folded outweighs a smaller outline and the flaps of a few short edges. Flaps that
// count by their length would do the same for all models, at the price of one flap in a hundred of
// those of triangles.
constexpr double kGlueOfPolygons = 5;

/// Makes nets better to craft: room for flaps, a small outline, strong necks, within the sheet; see
/// `CraftCost`. Between the rounds those are cut again that no sheet holds all the same. Nets stay
/// free of overlap, and those that fold straight are certified anew. Of nets on congruent faces one
/// is improved, and the others become its copies, so that equal parts are cut in equal ways.
class CompactStage : public Stage {
 public:
  StageId id() const override { return StageId::kCompact; }

  bool prepare(JobState& state) override {
    if (!has_work(state)) return true;
    if (!scale_finder_) scale_finder_.emplace(state);
    return scale_finder_->step();
  }

  void begin(JobState& state, TaskQueue& queue, Events&) override {
    if (!scale_finder_) return;
    scale_ = scale_finder_->scale();
    begin_round(state, queue);
  }

  void complete(JobState& state, TaskQueue& queue, CompletedTask done, Events&) override {
    auto& [task, result] = done;
    if (const auto* planned = std::get_if<PlanResult>(&result)) {
      checked(state, task, *planned);
    } else {
      compacted(state, task, std::get<CompactResult>(result));
    }
    if (nets_.empty() && copies_.empty()) go_on_with_round(state, queue);
  }

  double progress(const JobState& state, const Running& running) const override {
    if (!borders_) return 1;
    double done = static_cast<double>(state.nets.found.size() - nets_.size());
    for (const auto& [task, status] : running) done += status.progress;
    // The round that only measures counts for nothing.
    return std::max(0.0, (round_ + done / static_cast<double>(state.nets.found.size())) / kRounds);
  }

 private:
  /// What becomes of a net if it folds.
  struct Copy {
    int net;
    FoundNet copy;
  };
  /// Of a round, see `go_on_with_round`.
  enum class Step { kImprove, kCopy, kMeasure };

  /// Nets that are all kept stay as they are.
  static bool has_work(const JobState& state) {
    const auto is_kept = [](const FoundNet& net) { return net.region.kept; };
    return state.options.nets.compaction && !std::ranges::all_of(state.nets.found, is_kept);
  }

  void compacted(JobState& state, int task, CompactResult& compact) {
    const int n = nets_.at(task);
    nets_.erase(task);
    FoundNet& net = state.nets.found[n];
    if (net.folds != compact.folds) {
      net.folds = std::move(compact.folds);
      if (net.motion.kind == Folding::kLine) net.motion = straight_motion(net.folds);
    }
    borders_->note(n, compact.borders);
    state.nets.moves += compact.moves;
  }

  /// A copy that folds as its twin does takes the place of the net.
  void checked(JobState& state, int task, const PlanResult& planned) {
    auto& [n, copy] = copies_.at(task);
    if (planned.motion.kind == Folding::kLine) {
      copy.motion = planned.motion;
      state.nets.found[n] = std::move(copy);
    }
    copies_.erase(task);
  }

  /// A round has three steps: one net of each kind is improved, the others become its copies, and
  /// where these have changed, the room at their borders is measured for the next round.
  void go_on_with_round(JobState& state, TaskQueue& queue) {
    if (step_ == Step::kImprove) {
      step_ = Step::kCopy;
      copy_twins(state, queue);
    }
    if (step_ == Step::kCopy && copies_.empty()) {
      step_ = Step::kMeasure;
      if (round_ + 1 < kRounds) measure_twins(state, queue);
    }
    if (step_ != Step::kMeasure || !nets_.empty() || ++round_ >= kRounds) return;
    begin_round(state, queue);
  }

  void copy_twins(JobState& state, TaskQueue& queue) {
    for (int n = 0; n < static_cast<int>(twins_.size()); ++n) {
      if (!twins_[n]) continue;
      auto copy = copy_of_twin(state, state.nets.found[n], *twins_[n]);
      if (!copy) continue;
      if (state.nets.found[twins_[n]->of].motion.certified() && !copy->motion.certified()) {
        // The planner tries first whether it folds straight.
        PlanTask task{copy->folds, state.options.nets.clearance, 0};
        copies_[queue.add(state.model.surface, model_panels(state, copy->region),
                          std::move(task))] = {n, *copy};
      } else {
        state.nets.found[n] = *std::move(copy);
      }
    }
  }

  void measure_twins(JobState& state, TaskQueue& queue) {
    for (int n = 0; n < static_cast<int>(twins_.size()); ++n) {
      if (twins_[n]) queue_net(state, queue, n);
    }
  }

  /// Round -1 measures what room there is.
  void begin_round(JobState& state, TaskQueue& queue) {
    step_ = Step::kImprove;
    if (round_ == 1 && state.options.paper.size.by != Sizing::kSheets) {
      const std::size_t before = state.nets.found.size();
      state.nets.found = recut_nets(state, std::move(state.nets.found), scale_);
      if (state.nets.found.size() != before) borders_.reset();
    }
    if (!borders_) borders_.emplace(state);
    if (round_ >= 0) twins_ = find_twins(state);
    for (int n = 0; n < static_cast<int>(state.nets.found.size()); ++n) queue_net(state, queue, n);
  }

  void queue_net(const JobState& state, TaskQueue& queue, int n) {
    const FoundNet& net = state.nets.found[n];
    std::vector<int> panels = model_panels(state, net.region);
    const std::uint64_t seed =
        task_seed(state.options.seed, SeedTag::kAnnealing, static_cast<std::uint64_t>(n),
                  static_cast<std::uint64_t>(round_ + 1));
    // A net that folds over waypoints only stays as it is: its motion is known for this tree alone.
    // So does one that an edit leaves alone, and one that becomes a copy.
    const bool stays = round_ < 0 || net.motion.kind == Folding::kWaypoints || net.region.kept ||
                       twins_[n].has_value();
    CompactTask task{net.folds, craft_options(state, n), {}};
    task.annealing.work = stays ? 0 : work_for(state, panels.size());
    task.annealing.clearance = net.motion.kind == Folding::kLine ? state.options.nets.clearance : 0;
    task.annealing.seed = seed;
    nets_[queue.add(state.model.surface, std::move(panels), std::move(task))] = n;
  }

  static std::int64_t work_for(const JobState& state, std::size_t panels) {
    const auto all = static_cast<std::int64_t>(state.model.surface->graph.panel_count());
    const std::int64_t total = std::min(kMostWork, kWorkPerFace * all);
    return total * static_cast<std::int64_t>(panels) / all / kRounds;
  }

  CraftOptions craft_options(const JobState& state, int n) const {
    CraftOptions craft;
    craft.scale = scale_;
    craft.shape = state.options.paper.flaps.shape;
    const Component& component = state.parts.components[state.nets.found[n].region.component];
    if (is_of_polygons(component.graph)) craft.weights.glue = kGlueOfPolygons;
    if (state.options.paper.flaps.side == FlapSide::kNone) {
      craft.weights.flaps = 0;
    } else {
      craft.borders = borders_->seen_by(n);
    }
    // Without a wish for a size the model grows until the largest piece just fits.
    if (state.options.paper.size.by != Sizing::kFit)
      craft.room = printable(state.options.paper.sheet);
    return craft;
  }

  std::optional<FinishedScale> scale_finder_;
  double scale_ = 1;
  int round_ = -1;
  std::optional<BorderRooms> borders_;
  std::map<int, int> nets_;  ///< by task
  std::vector<std::optional<Twin>> twins_;
  std::map<int, Copy> copies_;  ///< that are looked at whether they fold, by task
  Step step_ = Step::kImprove;
};

}  // namespace

std::unique_ptr<Stage> make_compact_stage() { return std::make_unique<CompactStage>(); }

}  // namespace foldwright
