#include "pipeline/nets/coarser_parts.h"

#include <algorithm>
#include <string>
#include <utility>

namespace foldwright {
namespace {

// A body is tried as a whole where its parts come to so many pieces more than twice their number.
constexpr int kManyMore = 4;

// Larger bodies have no net as a whole, or take minutes to find one.
constexpr int kMostPanels = 1000;

/// Takes the nets of a component out of the state.
std::vector<FoundNet> take_nets(JobState& state, int component) {
  std::vector<FoundNet> taken;
  std::vector<FoundNet> others;
  for (FoundNet& net : state.nets.found) {
    (net.region.component == component ? taken : others).push_back(std::move(net));
  }
  state.nets.found = std::move(others);
  return taken;
}

/// Makes a part of each net. \pre there are at least as many nets as parts
void make_parts(JobState& state, int index, std::vector<FoundNet>& nets) {
  Component& component = state.parts.components[index];
  std::ranges::sort(nets, {}, [](const FoundNet& net) { return net.region.panels[0]; });
  for (std::size_t i = 0; i < nets.size(); ++i) {
    if (i == component.part_numbers.size()) component.part_numbers.push_back(state.parts.count++);
    Region& region = nets[i].region;
    region.part = component.part_numbers[i];
    region.cause = Cause::kPart;
    for (const int panel : region.panels) component.labels[panel] = static_cast<int>(i);
  }
}

}  // namespace

std::vector<Region> CoarserParts::begin(JobState& state) {
  std::vector<Region> regions;
  for (int c = 0; c < static_cast<int>(state.parts.components.size()); ++c) {
    const Component& component = state.parts.components[c];
    const auto parts = static_cast<std::ptrdiff_t>(component.part_numbers.size());
    const auto is_of = [&](const FoundNet& net) { return net.region.component == c; };
    const auto pieces = std::ranges::count_if(state.nets.found, is_of);
    const int panels = component.graph.panel_count();
    if (parts < 2 || panels > kMostPanels || pieces <= 2 * parts + kManyMore) continue;
    trials_.push_back({c, take_nets(state, c)});
    Region& whole = regions.emplace_back();
    whole.component = c;
    whole.part = component.part_numbers[0];
    whole.cause = Cause::kNoNet;
    for (int panel = 0; panel < panels; ++panel) whole.panels.push_back(panel);
  }
  return regions;
}

bool CoarserParts::end(JobState& state) {
  bool has_changed = false;
  for (Trial& trial : std::exchange(trials_, {})) {
    std::vector<FoundNet> found = take_nets(state, trial.component);
    const std::size_t parts = state.parts.components[trial.component].part_numbers.size();
    const bool is_better = found.size() >= parts && found.size() < trial.parts.size();
    if (is_better) {
      has_changed = true;
      make_parts(state, trial.component, found);
      state.notices.push_back({"parts-raised",
                               {{"what", "pieces"},
                                {"parts", parts},
                                {"pieces", trial.parts.size()},
                                {"instead", found.size()}}});
    }
    std::vector<FoundNet>& kept = is_better ? found : trial.parts;
    std::ranges::move(kept, std::back_inserter(state.nets.found));
  }
  return has_changed;
}

void CoarserParts::abandon(JobState& state) {
  for (Trial& trial : std::exchange(trials_, {})) {
    take_nets(state, trial.component);
    std::ranges::move(trial.parts, std::back_inserter(state.nets.found));
  }
}

}  // namespace foldwright
