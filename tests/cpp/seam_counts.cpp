#include "seam_counts.h"

#include <set>
#include <utility>
#include <vector>

#include "paper/seams.h"

namespace foldwright::testing {

SeamCounts count_seams(const JobResult& result) {
  std::vector<Net> nets;
  std::set<std::pair<int, int>> flaps;  // by net and first edge
  for (const Piece& piece : result.pieces) {
    for (const Flap& flap : piece.flaps) flaps.insert({static_cast<int>(nets.size()), flap.edge});
    nets.push_back(piece.net);
  }
  const std::vector<Seam> seams = find_seams(nets);
  SeamCounts counts;
  counts.seams = static_cast<int>(seams.size());
  for (const Seam& seam : seams) counts.glue += seam.sides[0].length();
  for (const std::vector<SeamStep>& chain : seam_chains(seams)) {
    const Seam& first = seams[chain.front().seam];
    const bool is_within = first.sides[0].net == first.sides[1].net;
    SeamCounts::Turns& turns = is_within ? counts.within : counts.between;
    int last = -1;
    for (const auto& [seam, side] : chain) {
      for (const int bank : {0, 1}) {
        const SeamSide& at = seams[seam].sides[bank == 0 ? side : 1 - side];
        if (!flaps.contains({at.net, at.edge()})) continue;
        if (last != -1) ++turns.followers;
        if (last != -1 && last != bank) ++turns.changes;
        last = bank;
      }
    }
  }
  return counts;
}

}  // namespace foldwright::testing
