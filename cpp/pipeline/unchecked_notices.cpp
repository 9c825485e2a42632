#include "pipeline/unchecked_notices.h"

#include <map>
#include <string>

namespace foldwright {
namespace {

enum class Why { kOff, kCancelled, kKept, kHuge, kLarge };

Why why_unchecked(const JobState& state, const Region& region) {
  if (state.options.folding == FoldingMode::kOff) return Why::kOff;
  if (state.in_a_hurry) return Why::kCancelled;
  if (region.kept) return Why::kKept;
  return region.too_large ? Why::kHuge : Why::kLarge;
}

std::string sentence(Why why, const std::string& pieces) {
  const std::string unasked = "no way to fold up " + pieces + " was looked for: ";
  switch (why) {
    case Why::kOff:
      return unasked + "folding is switched off";
    case Why::kCancelled:
      return unasked + "the run was cancelled before";
    case Why::kKept:
      return unasked + "the earlier result, which is kept, had none";
    case Why::kHuge:
      return unasked + "so many faces take too long; more parts, or fewer faces, would help";
    case Why::kLarge:
      return "turning all folds evenly does not fold up " + pieces +
             ", and with so many faces no other way was looked for; more parts, or fewer faces, "
             "would help";
  }
  return "";
}

}  // namespace

void add_unchecked_notices(JobState& state, std::span<const FoundNet> nets) {
  std::map<Why, std::vector<std::string>> names;
  for (std::size_t i = 0; i < nets.size(); ++i) {
    const Piece& piece = state.result->pieces[i];
    if (piece.motion.kind != Folding::kUnchecked) continue;
    names[why_unchecked(state, nets[i].region)].push_back(piece.name);
  }
  for (const auto& [why, of] : names) {
    std::string pieces = of.size() == 1 ? "piece " : "pieces ";
    for (std::size_t i = 0; i < of.size(); ++i) pieces += (i == 0 ? "" : ", ") + of[i];
    state.notices.push_back({"unchecked-pieces", sentence(why, pieces)});
  }
}

}  // namespace foldwright
