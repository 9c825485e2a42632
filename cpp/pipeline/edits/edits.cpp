#include "pipeline/edits/edits.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "mesh/connectivity.h"
#include "mesh/input_error.h"
#include "pipeline/edits/net_edits.h"
#include "pipeline/saved_net.h"

namespace foldwright {
namespace {

using Panels = std::vector<int>;

/// The parts as people count them.
std::vector<int> numbers_of(std::vector<int> parts) {
  for (int& part : parts) ++part;
  return parts;
}

/// The panels of each part of the earlier result.
std::vector<Panels> panels_by_part(const DualGraph& graph, const std::vector<int>& labels) {
  if (labels.size() != graph.faces.size()) throw foreign_start();
  std::vector<Panels> parts;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    const auto faces = graph.panel_faces(panel);
    const int part = labels[faces[0]];
    const auto strays = [&](int face) { return labels[face] != part; };
    if (part < 0 || part >= graph.panel_count() || std::ranges::any_of(faces, strays)) {
      throw foreign_start();
    }
    if (part >= static_cast<int>(parts.size())) parts.resize(part + 1);
    parts[part].push_back(panel);
  }
  for (const Panels& panels : parts) {
    if (panels.empty() || !is_connected(restrict_to(graph, panels))) throw foreign_start();
  }
  return parts;
}

void check_names(int part_count, std::span<const PartEdit> edits) {
  std::set<int> named;
  for (const PartEdit& edit : edits) {
    if (edit.parts.empty()) throw InputError("bad-edit", {{"what", "no-part-named"}});
    for (const int part : edit.parts) {
      if (part < 0 || part >= part_count) {
        throw InputError("bad-edit",
                         {{"what", "no-part"}, {"part", part + 1}, {"parts", part_count}});
      }
      if (!named.insert(part).second) {
        throw InputError("bad-edit", {{"what", "twice"}, {"part", part + 1}});
      }
    }
  }
}

/// What becomes of the parts that an edit names.
Component edited(const DualGraph& graph, const std::vector<Panels>& parts, const PartEdit& edit) {
  Panels panels;
  for (const int part : edit.parts) {
    panels.insert(panels.end(), parts[part].begin(), parts[part].end());
  }
  std::ranges::sort(panels);
  Component component = make_component(graph, std::move(panels));
  if (!is_connected(component.graph)) {
    throw InputError("bad-edit", {{"what", "apart"}, {"parts", numbers_of(edit.parts)}});
  }
  const int most = component.graph.panel_count();
  if (edit.into < 1 || edit.into > most) {
    throw InputError(
        "bad-edit",
        {{"what", "into"}, {"parts", numbers_of(edit.parts)}, {"into", edit.into}, {"most", most}});
  }
  component.parts = edit.into;
  return component;
}

/// Sets of panels that touch each other and have no net.
std::vector<Panels> open_shares(const Component& component) {
  Labels labels(component.graph.panel_count(), 0);
  for (const FoundNet& net : component.kept) {
    for (const int panel : net.region.panels) labels[panel] = 1;
  }
  const Labels pieces = part_pieces(component.graph, labels);
  std::map<int, Panels> open;
  for (std::size_t panel = 0; panel < labels.size(); ++panel) {
    if (labels[panel] == 0) open[pieces[panel]].push_back(static_cast<int>(panel));
  }
  std::vector<Panels> shares;
  for (auto& [piece, panels] : open) shares.push_back(std::move(panels));
  return shares;
}

/// A part as it was, with its nets; what they leave out is searched.
Component kept(const DualGraph& graph, int index, const Panels& panels, int number,
               const std::vector<SavedNet>& nets) {
  Component component = make_component(graph, panels);
  component.parts = 1;
  component.part_numbers = {number};
  std::size_t covered = 0;
  for (const SavedNet& net : nets) {
    component.kept.push_back(load_net(component, index, net));
    component.kept.back().region.part = number;
    covered += net.faces.size();
  }
  if (covered > component.graph.faces.size()) throw foreign_start();
  if (!component.kept.empty()) component.open = open_shares(component);
  return component;
}

/// Pins go with their faces to the numbers of the parts after the edits; those of parts that are
/// made anew keep theirs.
void carry_pins(std::span<const int> labels, const EditedNumbers& numbers,
                std::vector<PinnedPiece>& pins) {
  for (PinnedPiece& pin : pins) {
    if (pin.face >= static_cast<int>(labels.size())) continue;
    const int number = numbers.of_part[labels[pin.face]];
    if (number != -1) pin.part = number;
  }
}

/// The nets of the start after its edits of single nets; names go with their parts.
EarlierNets edit_nets(JobState& state, const JobStart& start) {
  EarlierNets nets{start.labels, 0, start.nets};
  if (start.net_edits.empty()) return nets;
  nets.part_count =
      static_cast<int>(panels_by_part(state.model.surface->graph, start.labels).size());
  const double scale = start.paper ? start.paper->scale : 1;
  for (const NetEdit& edit : start.net_edits) {
    const int count = nets.part_count;
    const auto merged = apply_net_edit(*state.model.surface, scale, edit, nets);
    if (!merged) continue;
    const std::span<const PartEdit> edits(&*merged, 1);
    state.parts.names = carry_names(state.parts.names, edits, number_parts(count, edits));
  }
  return nets;
}

}  // namespace

EditedNumbers number_parts(int count, std::span<const PartEdit> edits) {
  EditedNumbers numbers;
  numbers.count = count;
  numbers.of_part.resize(count);
  std::iota(numbers.of_part.begin(), numbers.of_part.end(), 0);
  std::set<int> open;
  for (const PartEdit& edit : edits) {
    std::vector<int>& own = numbers.of_edit.emplace_back(edit.parts);
    std::ranges::sort(own);
    for (const int part : own) numbers.of_part[part] = -1;
    while (static_cast<int>(own.size()) > edit.into) open.insert(own.back()), own.pop_back();
  }
  for (std::size_t i = 0; i < edits.size(); ++i) {
    std::vector<int>& own = numbers.of_edit[i];
    while (static_cast<int>(own.size()) < edits[i].into) {
      own.push_back(open.empty() ? numbers.count++ : open.extract(open.begin()).value());
    }
  }
  const auto move_into_gaps = [&](std::vector<int>& of) {
    for (int& number : of) {
      if (number == numbers.count && !open.empty()) number = open.extract(open.begin()).value();
    }
  };
  while (!open.empty()) {
    --numbers.count;
    if (open.erase(numbers.count) > 0) continue;
    move_into_gaps(numbers.of_part);
    for (std::vector<int>& own : numbers.of_edit) move_into_gaps(own);
  }
  for (std::vector<int>& own : numbers.of_edit) std::ranges::sort(own);
  return numbers;
}

std::vector<PartName> carry_names(std::span<const PartName> names, std::span<const PartEdit> edits,
                                  const EditedNumbers& numbers) {
  std::vector<PartName> carried;
  for (const auto& [part, name] : names) {
    if (part >= static_cast<int>(numbers.of_part.size())) continue;
    if (numbers.of_part[part] != -1) carried.push_back({numbers.of_part[part], name});
  }
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].into != 1) continue;
    const auto is_named = [&](const PartName& chosen) {
      return std::ranges::count(edits[i].parts, chosen.part) > 0;
    };
    if (std::ranges::count_if(names, is_named) != 1) continue;
    carried.push_back({numbers.of_edit[i][0], std::ranges::find_if(names, is_named)->name});
  }
  return carried;
}

void start_from_earlier(JobState& state) {
  const JobStart& start = *state.start;
  const DualGraph& graph = state.model.surface->graph;
  const EarlierNets earlier = edit_nets(state, start);
  const std::vector<Panels> parts = panels_by_part(graph, earlier.labels);
  check_names(static_cast<int>(parts.size()), start.part_edits);
  for (const PartEdit& edit : start.part_edits) {
    state.parts.components.push_back(edited(graph, parts, edit));
  }
  const EditedNumbers numbers = number_parts(static_cast<int>(parts.size()), start.part_edits);
  for (std::size_t i = 0; i < start.part_edits.size(); ++i) {
    state.parts.components[i].part_numbers = numbers.of_edit[i];
  }
  state.parts.names = carry_names(state.parts.names, start.part_edits, numbers);
  carry_pins(earlier.labels, numbers, state.parts.pins);
  std::vector<std::vector<SavedNet>> nets(parts.size());
  for (const SavedNet& net : earlier.nets) {
    if (net.part < 0 || net.part >= static_cast<int>(parts.size())) throw foreign_start();
    nets[net.part].push_back(net);
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (numbers.of_part[part] == -1) continue;
    const int index = static_cast<int>(state.parts.components.size());
    state.parts.components.push_back(
        kept(graph, index, parts[part], numbers.of_part[part], nets[part]));
  }
}

}  // namespace foldwright
