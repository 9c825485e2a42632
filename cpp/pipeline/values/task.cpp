#include "pipeline/values/task.h"

#include <algorithm>
#include <utility>

namespace foldwright {
namespace {

// Moves of the tree search that count as one generation in events: some milliseconds.
constexpr std::int64_t kMovesPerBatch = 500;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

NetPicture make_picture(const DualGraph& graph, std::span<const int> folds) {
  const Layout layout = lay_out(graph, hang_tree(graph, folds));
  std::vector<std::uint8_t> overlaps(graph.panel_count(), 0);
  for (const auto& [a, b] : overlapping_panels(graph, layout)) overlaps[a] = overlaps[b] = 1;
  NetPicture picture;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    for (int i = graph.first_face[panel]; i < graph.first_face[panel + 1]; ++i) {
      for (const Vec2& corner : moved(layout[panel], graph.triangles[i])) {
        picture.corners.push_back(static_cast<float>(corner.x()));
        picture.corners.push_back(static_cast<float>(corner.y()));
      }
      picture.sources.push_back(graph.faces[i]);
      picture.overlapping.push_back(overlaps[panel]);
    }
  }
  return picture;
}

}  // namespace

std::shared_ptr<const Surface> make_surface(int key, Mesh mesh, std::vector<EdgeLock> locks) {
  DualGraph graph = lock_edges(mesh, build_dual_graph(mesh), locks);
  return std::make_shared<const Surface>(
      Surface{key, std::move(mesh), std::move(graph), std::move(locks)});
}

TaskRunner::TaskRunner(Task task)
    : task_(std::move(task)), graph_(restrict_to(task_.surface->graph, task_.panels)) {
  const Mesh& mesh = task_.surface->mesh;
  std::visit(Overloaded{
                 [&](const LearnTask& learn) {
                   const RunRange runs = {learn.first_run, learn.last_run};
                   run_.emplace<FoldabilityLearner>(mesh, graph_, learn.options, runs);
                 },
                 [&](const SearchTask& search) {
                   run_.emplace<TreeSearch>(mesh, graph_, search.options, search.initial);
                 },
                 [&](const GeneticTask& search) {
                   run_.emplace<GeneticSearch>(mesh, graph_, search.options);
                 },
                 [&](const ExchangeTask& exchange) {
                   run_.emplace<BorderExchange>(mesh, graph_, exchange.parts, exchange.options);
                 },
                 [&](const PlanTask& plan) {
                   foldable_ = make_foldable(graph_, plan.clearance);
                   run_.emplace<MotionPlanner>(*foldable_, plan.folds, plan.seed);
                 },
                 [&](const CompactTask& compact) {
                   run_.emplace<NetAnnealing>(
                       graph_, compact.folds,
                       std::make_unique<CraftCost>(mesh, graph_, compact.craft), compact.annealing);
                 },
             },
             task_.work);
}

bool TaskRunner::step(std::int64_t work) {
  const bool done = std::visit(
      Overloaded{
          [](std::monostate) { return true; },
          [&](FoldabilityLearner& learner) {
            // A run lays the graph out and analyses it: about two microseconds a panel.
            const std::int64_t run = 1 + 2 * graph_.panel_count();
            do {
              if (!learner.step()) return true;
              work -= run;
            } while (work > 0);
            return false;
          },
          [&](GeneticSearch& search) {
            // Generation by generation, so that none goes unnoticed.
            const std::int64_t slice = std::max<std::int64_t>(1, graph_.panel_count());
            while (work > 0 && search.step(slice) == GeneticSearch::State::kRunning) {
              note_generation();
              work -= slice;
            }
            return search.state() != GeneticSearch::State::kRunning;
          },
          [&](MotionPlanner& planner) { return planner.step(work); },
          [&](auto& search) { return search.step(work) != decltype(search.step(0))::kRunning; },
      },
      run_);
  note_generation();
  return done;
}

bool TaskRunner::is_folding() const {
  return std::visit(Overloaded{
                        [](const MotionPlanner&) { return true; },
                        [&](const TreeSearch& search) {
                          return std::get<SearchTask>(task_.work).options.clearance > 0 &&
                                 search.best_overlaps() == 0;
                        },
                        [&](const BorderExchange&) {
                          return std::get<ExchangeTask>(task_.work).options.clearance > 0;
                        },
                        [](const auto&) { return false; },
                    },
                    run_);
}

/// Adds a status when a generation has passed since the last one.
void TaskRunner::note_generation() {
  const auto note = [&](std::int64_t generation, const SearchStatus& status) {
    if (generation <= last_generation_ && status.overlaps != 0) return;
    last_generation_ = static_cast<int>(generation);
    generations_.push_back(status);
  };
  std::visit(Overloaded{
                 [](std::monostate) {},
                 [](const FoldabilityLearner&) {},
                 [](const MotionPlanner&) {},
                 [](const NetAnnealing&) {},
                 [&](const GeneticSearch& search) {
                   note(search.generation(), {search.best_value(), search.best_fitness().overlaps,
                                              search.best_fitness().hyperbolic});
                 },
                 [&](const TreeSearch& search) {
                   note(1 + search.moves() / kMovesPerBatch,
                        {-static_cast<double>(search.best_overlaps()), search.best_overlaps(), 0});
                 },
                 [&](const BorderExchange& exchange) {
                   if (exchange.shortfall() < 0) return;  // its first search is under way
                   note(1 + exchange.moves() / kMovesPerBatch,
                        {-static_cast<double>(exchange.shortfall()), exchange.shortfall(), 0});
                 },
             },
             run_);
}

const FoldTree* TaskRunner::best_tree() const {
  if (const auto* search = std::get_if<TreeSearch>(&run_)) return &search->best();
  if (const auto* search = std::get_if<GeneticSearch>(&run_)) return &search->best();
  return nullptr;
}

TaskStatus TaskRunner::status(bool with_net) {
  TaskStatus status;
  status.generations = std::exchange(generations_, {});
  if (const auto* learner = std::get_if<FoldabilityLearner>(&run_)) {
    const LearnTask& learn = std::get<LearnTask>(task_.work);
    status.runs = learner->runs_done();
    status.progress =
        static_cast<double>(status.runs) / std::max(1, learn.last_run - learn.first_run);
  } else if (const auto* tree = std::get_if<TreeSearch>(&run_)) {
    status.progress = tree->impatience();
  } else if (const auto* genetic = std::get_if<GeneticSearch>(&run_)) {
    status.progress = genetic->progress();
  } else if (const auto* exchange = std::get_if<BorderExchange>(&run_)) {
    status.progress = exchange->progress();
  } else if (const auto* planner = std::get_if<MotionPlanner>(&run_)) {
    status.progress = planner->progress();
  } else if (const auto* annealing = std::get_if<NetAnnealing>(&run_)) {
    status.progress = annealing->progress();
  }
  const FoldTree* tree = with_net ? best_tree() : nullptr;
  const bool spans = tree != nullptr && static_cast<int>(tree->size()) + 1 == graph_.panel_count();
  if (spans) status.net = make_picture(graph_, *tree);
  return status;
}

TaskResult TaskRunner::result() const {
  if (const auto* learner = std::get_if<FoldabilityLearner>(&run_)) return learner->counts();
  if (const auto* tree = std::get_if<TreeSearch>(&run_)) {
    const bool is_found = tree->state() == TreeSearch::State::kFound;
    const bool folds = std::get<SearchTask>(task_.work).options.clearance > 0;
    return SearchResult{tree->best(),      tree->best_overlaps(), tree->shortfall(),
                        is_found && folds, tree->moves(),         0};
  }
  if (const auto* genetic = std::get_if<GeneticSearch>(&run_)) {
    const int overlaps = genetic->best_fitness().overlaps;
    return SearchResult{genetic->best(), overlaps, overlaps, false, 0, genetic->generation()};
  }
  if (const auto* planner = std::get_if<MotionPlanner>(&run_)) return PlanResult{planner->motion()};
  if (const auto* annealing = std::get_if<NetAnnealing>(&run_)) {
    CraftCost cost(task_.surface->mesh, graph_, std::get<CompactTask>(task_.work).craft);
    cost.lay(annealing->best(), lay_out(graph_, hang_tree(graph_, annealing->best())));
    return CompactResult{annealing->best(), cost.border_rooms(), annealing->moves()};
  }
  const auto& exchange = std::get<BorderExchange>(run_);
  return ExchangeResult{exchange.shortfall() == 0, exchange.labels(), exchange.trees(),
                        exchange.shortfalls(), exchange.moves()};
}

}  // namespace foldwright
