#include "paper/seam_ids.h"

#include <algorithm>
#include <map>
#include <utility>

#include "paper/outline.h"

namespace foldwright {
namespace {

/// The seams in the order in which they come along the outlines, piece by piece.
std::vector<int> along_outlines(std::span<const Net> nets, std::span<const Seam> seams) {
  std::map<std::pair<int, int>, int> seam_from;  // by net and the vertex that the run starts from
  for (int i = 0; i < static_cast<int>(seams.size()); ++i) {
    for (const SeamSide& side : seams[i].sides) {
      seam_from[{side.net, nets[side.net].edges[side.edge()].vertices[0]}] = i;
    }
  }
  std::vector<char> seen(seams.size(), 0);
  std::vector<int> order;
  for (int n = 0; n < static_cast<int>(nets.size()); ++n) {
    for (const std::vector<int>& walk : boundary_walks(nets[n])) {
      for (const int vertex : walk) {
        const auto seam = seam_from.find({n, vertex});
        if (seam == seam_from.end() || std::exchange(seen[seam->second], 1)) continue;
        order.push_back(seam->second);
      }
    }
  }
  return order;
}

/// A name in front of a number, so that both can be told apart.
std::string prefix(const std::string& name) {
  const bool is_letters =
      std::ranges::all_of(name, [](char byte) { return byte >= 'A' && byte <= 'Z'; });
  return is_letters ? name : name + ":";
}

}  // namespace

std::vector<SeamId> name_seams(std::span<const Net> nets, std::span<const std::string> names,
                               std::span<const Seam> seams, std::span<const Seam> joints) {
  std::map<std::pair<int, int>, int> last;  // number, by pair of nets
  const auto name = [&](const Seam& seam) {
    const auto [low, high] = std::minmax({seam.sides[0].net, seam.sides[1].net});
    const std::string number = std::to_string(++last[{low, high}]);
    if (low == high) return SeamId{{number, number}, names[low] + ":" + number};
    SeamId id;
    for (const int s : {0, 1}) id.texts[s] = prefix(names[seam.sides[1 - s].net]) + number;
    id.name = names[low] + "-" + names[high] + ":" + number;
    return id;
  };
  std::vector<SeamId> ids(seams.size());
  for (const int seam : along_outlines(nets, seams)) ids[seam] = name(seams[seam]);
  for (const Seam& joint : joints) ids.push_back(name(joint));
  return ids;
}

}  // namespace foldwright
