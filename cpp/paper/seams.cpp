#include "paper/seams.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "paper/outline.h"

namespace foldwright {
namespace {

// How far the ends of edges may lie off a straight line, in mm: half of what files round to.
constexpr double kStraight = 0.005;

bool is_cut(const NetEdge& edge) { return edge.assignment == Assignment::kCut; }

/// The panel of a side, seen from the side as a base.
FlapCover panel_over(const SeamSide& side, const Net& net, const NetPanels& panels) {
  const SeamFrame frame = side.frame();
  const auto place = [&](int vertex) {
    const Vec2 p = frame.local(net.vertices[vertex]);
    return Vec2(p.x(), -p.y());  // into the panel
  };
  CoverBuilder cover(side.length());
  for (const auto& [from, to] : panels.borders(panels.panel_of(side.faces.front()))) {
    if (to == side.base[0]) {
      cover.add_at_end(0, place(from));
    } else if (from == side.base[1]) {
      cover.add_at_end(1, place(to));
    } else {
      cover.add(place(from), place(to));
    }
  }
  return cover.take();
}

/// An edge of a net of several.
struct Place {
  int net, edge;
  auto operator<=>(const Place&) const = default;
};
constexpr Place kNowhere = {-1, -1};

/// Edges of nets that were come by.
class SeenEdges {
 public:
  explicit SeenEdges(std::span<const Net> nets) {
    for (const Net& net : nets) seen_.emplace_back(net.edges.size(), 0);
  }
  bool contains(const Place& at) const { return seen_[at.net][at.edge]; }
  void add(std::span<const Place> places) {
    for (const Place& at : places) seen_[at.net][at.edge] = 1;
  }

 private:
  std::vector<std::vector<char>> seen_;  ///< per net and edge
};

/// The cut edges of nets, with what follows and what lies opposite.
class CutEdges {
 public:
  CutEdges(std::span<const Net> nets, std::span<const NetPanels> panels)
      : nets_(nets), panels_(panels) {
    struct Side {
      int mesh_edge;
      Place place;
    };
    std::vector<Side> sides;
    for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
      starts_.emplace_back(nets[n].vertices.size(), -1);
      ends_.emplace_back(nets[n].vertices.size(), -1);
      across_.emplace_back(nets[n].edges.size(), kNowhere);
      for (int e = 0; e < static_cast<int>(nets[n].edges.size()); ++e) {
        const NetEdge& edge = nets[n].edges[e];
        if (!is_cut(edge)) continue;
        starts_[n][edge.vertices[0]] = e;
        ends_[n][edge.vertices[1]] = e;
        sides.push_back({edge.mesh_edge, {n, e}});
      }
    }
    std::ranges::sort(sides, {}, &Side::mesh_edge);
    // An edge of the mesh has two sides at most.
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i - 1].mesh_edge != sides[i].mesh_edge) continue;
      across_of(sides[i - 1].place) = sides[i].place;
      across_of(sides[i].place) = sides[i - 1].place;
    }
  }

  Place across(const Place& at) const { return across_[at.net][at.edge]; }

  /// The cut edge after this one along the outline.
  Place after(const Place& at) const { return {at.net, starts_[at.net][edge_at(at).vertices[1]]}; }
  Place before(const Place& at) const { return {at.net, ends_[at.net][edge_at(at).vertices[0]]}; }

  /// Whether two edges that follow each other lie at one panel on each side that they have.
  bool is_one_pair(const Place& first, const Place& second) const {
    if (panel_at(first) != panel_at(second)) return false;
    const Place a = across(first);
    const Place b = across(second);
    if (a == kNowhere || b == kNowhere) return a == b;
    // Seen from the other side they follow each other the other way.
    return after(b) == a && panel_at(a) == panel_at(b);
  }

  /// The straight run around an edge, in the order of the outline.
  std::vector<Place> run_at(const Place& at) const {
    std::vector<Place> run = {at};
    while (true) {
      const Place next = after(run.back());
      if (next == at || !is_one_pair(run.back(), next) || !stays_straight(run.front(), next)) break;
      run.push_back(next);
    }
    while (true) {
      const Place next = before(run.front());
      if (next == run.back() || !is_one_pair(next, run.front())) break;
      if (!stays_straight(next, run.back())) break;
      run.insert(run.begin(), next);
    }
    return run;
  }

  SeamSide side_of(const std::vector<Place>& run) const {
    const Net& net = nets_[run.front().net];
    SeamSide side;
    side.net = run.front().net;
    for (const Place& place : run) {
      side.edges.push_back(place.edge);
      side.faces.push_back(panels_[side.net].face_at(place.edge));
    }
    side.base = {net.edges[side.edges.front()].vertices[0],
                 net.edges[side.edges.back()].vertices[1]};
    side.from = net.vertices[side.base[0]];
    side.to = net.vertices[side.base[1]];
    side.panel = panel_over(side, net, panels_[side.net]);
    return side;
  }

  /// The same run along its other side.
  std::vector<Place> other_side(const std::vector<Place>& run) const {
    std::vector<Place> other;
    for (const Place& place : run) other.push_back(across(place));
    std::ranges::reverse(other);
    return other;
  }

 private:
  Place& across_of(const Place& at) { return across_[at.net][at.edge]; }
  const NetEdge& edge_at(const Place& at) const { return nets_[at.net].edges[at.edge]; }
  int panel_at(const Place& at) const {
    return panels_[at.net].panel_of(panels_[at.net].face_at(at.edge));
  }

  /// Whether the outline runs straight from the start of one edge to the end of another.
  bool stays_straight(const Place& first, const Place& last) const {
    const Net& net = nets_[first.net];
    const Vec2& from = net.vertices[edge_at(first).vertices[0]];
    const Vec2& to = net.vertices[edge_at(last).vertices[1]];
    const double length = (to - from).norm();
    double reached = 0;
    for (Place at = first; at != last; at = after(at)) {
      const Vec2 end = net.vertices[edge_at(at).vertices[1]] - from;
      const double along = end.dot(to - from) / length;
      // It goes on, never back: not so around a tip.
      if (along <= reached || along >= length) return false;
      if (std::abs(cross(to - from, end)) > kStraight * length) return false;
      reached = along;
    }
    return true;
  }

  std::span<const Net> nets_;
  std::span<const NetPanels> panels_;
  std::vector<std::vector<int>> starts_, ends_;  ///< per net and vertex: the cut edge there
  std::vector<std::vector<Place>> across_;       ///< per net and edge
};

}  // namespace

SeamFrame SeamSide::frame() const { return {from, (to - from) / length()}; }
Vec2 SeamSide::local(const Vec2& p) const { return frame().local(p); }
Vec2 SeamSide::global(const Vec2& p) const { return frame().global(p); }

std::vector<Seam> find_seams(std::span<const Net> nets, std::span<const NetPanels> panels) {
  const CutEdges cuts(nets, panels);
  std::vector<Seam> seams;
  SeenEdges seen(nets);
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (int e = 0; e < static_cast<int>(nets[n].edges.size()); ++e) {
      if (!is_cut(nets[n].edges[e]) || seen.contains({n, e})) continue;
      if (cuts.across({n, e}) == kNowhere) continue;
      const std::vector<Place> run = cuts.run_at({n, e});
      const std::vector<Place> other = cuts.other_side(run);
      Seam& seam = seams.emplace_back();
      seam.sides = {cuts.side_of(run), cuts.side_of(other)};
      const auto start = [](const SeamSide& side) { return std::pair(side.net, side.edge()); };
      if (start(seam.sides[1]) < start(seam.sides[0])) std::swap(seam.sides[0], seam.sides[1]);
      for (const Place& place : run) {
        seam.mesh_edges.push_back(nets[place.net].edges[place.edge].mesh_edge);
      }
      std::ranges::sort(seam.mesh_edges);
      seen.add(run);
      seen.add(other);
    }
  }
  std::ranges::sort(seams, {}, [](const Seam& seam) { return seam.mesh_edge(); });
  return seams;
}

std::vector<Seam> find_seams(std::span<const Net> nets) {
  return find_seams(nets, panels_of(nets));
}

std::map<std::pair<int, int>, SeamStep> seam_starts(std::span<const Seam> seams) {
  std::map<std::pair<int, int>, SeamStep> starts;
  for (int i = 0; i < static_cast<int>(seams.size()); ++i) {
    for (const int s : {0, 1}) {
      const SeamSide& side = seams[i].sides[s];
      starts[{side.net, side.base[0]}] = {i, s};
    }
  }
  return starts;
}

std::vector<std::vector<SeamStep>> steps_along_outlines(std::span<const Net> nets,
                                                        std::span<const Seam> seams) {
  const auto starts = seam_starts(seams);
  std::vector<std::vector<SeamStep>> steps(nets.size());
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (const std::vector<int>& walk : boundary_walks(nets[n])) {
      for (const int vertex : walk) {
        const auto step = starts.find({n, vertex});
        if (step != starts.end()) steps[n].push_back(step->second);
      }
    }
  }
  return steps;
}

std::vector<std::vector<SeamStep>> seam_chains(std::span<const Seam> seams) {
  const auto starts = seam_starts(seams);
  std::vector<char> seen(seams.size(), 0);
  // What comes after a step on its bank, as far as it does so on the other one, too.
  const auto after = [&](SeamStep step) {
    std::vector<SeamStep> steps;
    while (true) {
      const SeamSide& side = seams[step.seam].sides[step.side];
      const SeamSide& other = seams[step.seam].sides[1 - step.side];
      const auto next = starts.find({side.net, side.base[1]});
      if (next == starts.end() || seen[next->second.seam]) return steps;
      step = next->second;
      const SeamSide& beyond = seams[step.seam].sides[1 - step.side];
      if (other.net != beyond.net || other.base[0] != beyond.base[1]) return steps;
      seen[step.seam] = 1;
      steps.push_back(step);
    }
  };
  std::vector<std::vector<SeamStep>> chains;
  for (int i = 0; i < static_cast<int>(seams.size()); ++i) {
    if (std::exchange(seen[i], 1)) continue;
    const std::vector<SeamStep> ahead = after({i, 0});
    // Along the other bank the outline runs the other way.
    std::vector<SeamStep>& chain = chains.emplace_back(after({i, 1}));
    std::ranges::reverse(chain);
    for (SeamStep& step : chain) step.side = 1 - step.side;
    chain.push_back({i, 0});
    chain.insert(chain.end(), ahead.begin(), ahead.end());
  }
  return chains;
}

std::vector<Seam> find_joint_seams(const Mesh& mesh, std::span<const Net> nets) {
  if (mesh.joints.empty()) return {};
  const std::vector<NetPanels> panels = panels_of(nets);
  const CutEdges cuts(nets, panels);
  std::set<int> wanted;
  for (const auto& [edge, host] : mesh.joints) wanted.insert({edge, host});
  std::map<int, SeamSide> sides;  // by mesh edge; of a cut the first one
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (int e = 0; e < static_cast<int>(nets[n].edges.size()); ++e) {
      const int mesh_edge = nets[n].edges[e].mesh_edge;
      if (wanted.contains(mesh_edge)) sides.emplace(mesh_edge, cuts.side_of({{n, e}}));
    }
  }
  std::vector<Seam> joints;
  for (const auto& [edge, host] : mesh.joints) {
    const auto stands = sides.find(edge);
    const auto on = sides.find(host);
    if (stands == sides.end() || on == sides.end()) continue;
    joints.push_back({{edge}, {stands->second, on->second}});
  }
  return joints;
}

std::vector<SeamSide> find_borders(const Mesh& mesh, std::span<const Net> nets,
                                   std::span<const NetPanels> panels) {
  const CutEdges cuts(nets, panels);
  const auto is_joint = [&](int mesh_edge) {
    return std::ranges::binary_search(mesh.joints, mesh_edge, {}, &Joint::edge);
  };
  std::vector<SeamSide> borders;
  SeenEdges seen(nets);
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (int e = 0; e < static_cast<int>(nets[n].edges.size()); ++e) {
      const int mesh_edge = nets[n].edges[e].mesh_edge;
      if (!is_cut(nets[n].edges[e]) || mesh.edges[mesh_edge].faces[1] != -1) continue;
      if (seen.contains({n, e})) continue;
      std::vector<Place> run = cuts.run_at({n, e});
      const auto is_plain = [&](const Place& place) {
        const int at = nets[place.net].edges[place.edge].mesh_edge;
        return mesh.edges[at].faces[1] == -1 && !is_joint(at);
      };
      if (!std::ranges::all_of(run, is_plain)) run = {{n, e}};
      seen.add(run);
      borders.push_back(cuts.side_of(run));
    }
  }
  return borders;
}

FlapCover Seam::cover_of(int side) const {
  const SeamSide& other = sides[1 - side];
  return seen_back(other.panel, other.length());
}

}  // namespace foldwright
