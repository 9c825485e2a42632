#include "result_faults.h"

#include <algorithm>
#include <set>
#include <vector>

namespace foldwright::testing {

std::string fault_of(const JobResult& result) {
  std::vector<int> uses(result.mesh.faces.size(), 0);
  std::set<int> parts;
  for (const Piece& piece : result.pieces) {
    if (!piece.check.valid()) return "an invalid net";
    if (piece.outlines.empty()) return "a piece without an outline";
    parts.insert(piece.part);
    for (const int face : piece.net.faces) {
      ++uses[face];
      if (result.labels[face] != piece.part) return "a face on a piece of another part";
    }
  }
  if (std::ranges::any_of(uses, [](int count) { return count != 1; })) {
    return "a face that is not on just one piece";
  }
  const auto count = static_cast<int>(parts.size());
  if (count != result.parts || *parts.rbegin() != count - 1) return "parts without a piece";
  if (result.sheets.placements.size() != result.pieces.size()) return "pieces without a place";
  if (result.hash != hash_of(canonical_dump(result))) return "a wrong hash";
  return "";
}

}  // namespace foldwright::testing
