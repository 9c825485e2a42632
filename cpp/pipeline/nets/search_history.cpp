#include "pipeline/nets/search_history.h"

namespace foldwright {

void SearchHistory::tell(int part, const TaskStatus& status, Events& events) {
  OfPart& history = parts_[part];
  for (const SearchStatus& generation : status.generations) {
    if (history.generations++ == 0 || generation.best > history.best.best) {
      history.best = generation;
    }
    const SearchStatus& best = history.best;
    events.push_back(GenerationEvent{part, history.generations, best.best, best.overlaps,
                                     best.hyperbolic, std::nullopt});
  }
  if (status.generations.empty() || !status.net) return;
  std::get<GenerationEvent>(events.back()).net = status.net;
}

}  // namespace foldwright
