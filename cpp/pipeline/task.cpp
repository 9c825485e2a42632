#include "pipeline/task.h"

#include <algorithm>

namespace foldwright {

std::shared_ptr<const Surface> make_surface(Mesh mesh) {
  auto surface = std::make_shared<Surface>();
  surface->graph = build_dual_graph(mesh);
  surface->mesh = std::move(mesh);
  return surface;
}

TaskRunner::TaskRunner(Task task)
    : task_(std::move(task)), graph_(restrict_to(task_.surface->graph, task_.panels)) {
  const Mesh& mesh = task_.surface->mesh;
  if (const auto* learn = std::get_if<LearnTask>(&task_.work)) {
    learner_ = std::make_unique<FoldabilityLearner>(mesh, graph_, learn->options, learn->first_run,
                                                    learn->last_run);
  } else if (const auto* search = std::get_if<SearchTask>(&task_.work)) {
    search_ = std::make_unique<TreeSearch>(mesh, graph_, search->options);
  } else {
    const auto& exchange = std::get<ExchangeTask>(task_.work);
    exchange_ = std::make_unique<BorderExchange>(mesh, graph_, exchange.parts, exchange.options);
  }
}

bool TaskRunner::step(std::int64_t work) {
  if (search_) return search_->step(work) != TreeSearch::State::kRunning;
  if (exchange_) return exchange_->step(work) != BorderExchange::State::kRunning;
  // A run lays the graph out and analyses it: about two microseconds a panel.
  const std::int64_t run = 1 + 2 * graph_.panel_count();
  do {
    if (!learner_->step()) return true;
    work -= run;
  } while (work > 0);
  return false;
}

TaskResult TaskRunner::result() const {
  if (learner_) return learner_->counts();
  if (search_) return SearchResult{search_->best(), search_->best_overlaps(), search_->moves()};
  return ExchangeResult{exchange_->overlaps() == 0, exchange_->labels(), exchange_->trees(),
                        exchange_->overlaps_of(), exchange_->moves()};
}

double TaskRunner::progress() const {
  if (search_) return search_->impatience();
  if (exchange_) return exchange_->progress();
  const LearnTask& learn = std::get<LearnTask>(task_.work);
  return static_cast<double>(learner_->runs_done()) / std::max(1, learn.last_run - learn.first_run);
}

int TaskRunner::runs_done() const { return learner_ ? learner_->runs_done() : 0; }

int TaskRunner::overlaps() const {
  if (search_) return search_->best_overlaps();
  return exchange_ ? exchange_->overlaps() : -1;
}

}  // namespace foldwright
