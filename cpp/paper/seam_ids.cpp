#include "paper/seam_ids.h"

#include <algorithm>
#include <map>
#include <utility>

namespace foldwright {
namespace {

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
  for (const std::vector<SeamStep>& steps : steps_along_outlines(nets, seams)) {
    for (const auto& [seam, side] : steps) {
      if (ids[seam].name.empty()) ids[seam] = name(seams[seam]);
    }
  }
  for (const Seam& joint : joints) ids.push_back(name(joint));
  return ids;
}

}  // namespace foldwright
