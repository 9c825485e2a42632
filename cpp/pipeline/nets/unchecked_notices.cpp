#include "pipeline/nets/unchecked_notices.h"

#include <map>
#include <string>

namespace foldwright {
namespace {

enum class Why { kOff, kCancelled, kKept, kHuge, kLarge };

Why why_unchecked(const JobState& state, const Region& region) {
  if (state.options.nets.folding == FoldingMode::kOff) return Why::kOff;
  if (state.in_a_hurry) return Why::kCancelled;
  if (region.kept) return Why::kKept;
  return region.too_large ? Why::kHuge : Why::kLarge;
}

const char* word_for(Why why) {
  switch (why) {
    case Why::kOff:
      return "off";
    case Why::kCancelled:
      return "cancelled";
    case Why::kKept:
      return "kept";
    case Why::kHuge:
      return "huge";
    case Why::kLarge:
      return "large";
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
    state.notices.push_back({"unchecked-pieces", {{"what", word_for(why)}, {"pieces", of}}});
  }
}

}  // namespace foldwright
