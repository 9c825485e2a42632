#include "pipeline/nets/spare_nets.h"

#include <algorithm>
#include <utility>

namespace foldwright {
namespace {

/// Which panels have a net, by component.
class Covered {
 public:
  explicit Covered(const JobState& state) {
    for (const Component& component : state.parts.components) {
      panels_.emplace_back(component.graph.panel_count(), false);
    }
    for (const FoundNet& net : state.nets.found) add(net.region);
  }

  void add(const Region& region) {
    for (const int panel : region.panels) panels_[region.component][panel] = true;
  }

  bool meets(const Region& region) const {
    const std::vector<char>& own = panels_[region.component];
    return std::ranges::any_of(region.panels, [&](int panel) { return own[panel] != 0; });
  }

 private:
  std::vector<std::vector<char>> panels_;
};

/// Labels the panels of a region with its part; false if its component has no such part.
bool label(Component& component, const Region& region) {
  const auto part = std::ranges::find(component.part_numbers, region.part);
  if (part == component.part_numbers.end()) return false;
  const auto own = static_cast<int>(part - component.part_numbers.begin());
  for (const int panel : region.panels) component.labels[panel] = own;
  return true;
}

}  // namespace

void add_spare_nets(JobState& state, std::vector<FoundNet> nets) {
  if (nets.empty()) return;
  Covered covered(state);
  for (FoundNet& net : nets) {
    const Region& region = net.region;
    if (covered.meets(region) || !label(state.parts.components[region.component], region)) continue;
    covered.add(region);
    state.nets.found.push_back(std::move(net));
  }
}

}  // namespace foldwright
