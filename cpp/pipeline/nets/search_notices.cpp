#include "pipeline/nets/search_notices.h"

#include <map>
#include <string>

namespace foldwright {
namespace {

/// What a part came to.
struct Outcome {
  int pieces = 0;
  int without_motion = 0;
  bool meets_itself = false;
  Cause cause = Cause::kPart;
};

}  // namespace

void add_search_notices(JobState& state) {
  std::map<int, Outcome> outcomes;
  for (const FoundNet& net : state.nets.found) {
    Outcome& outcome = outcomes[net.region.part];
    // Those of an earlier result may have been cut for the sheet, which is told elsewhere, or by a
    // person, who knows.
    const bool is_told = net.region.cause == Cause::kSheet || net.region.cause == Cause::kEdit;
    outcome.pieces += !is_told;
    outcome.without_motion += net.motion.kind == Folding::kNone;
    outcome.meets_itself |= net.region.meets_itself;
    if (!is_told) outcome.cause = net.region.cause;
  }
  for (const auto& [part, outcome] : outcomes) {
    if (outcome.pieces > 1) {
      state.notices.push_back(
          {"part-split",
           {{"what", outcome.cause == Cause::kNoMotion ? "no-motion" : "no-net"},
            {"part", part + 1},
            {"pieces", outcome.pieces}}});
    }
    if (outcome.meets_itself) {
      state.notices.push_back({"meets-itself", {{"part", part + 1}}});
    } else if (outcome.without_motion > 0) {
      state.notices.push_back({"no-motion", {{"part", part + 1}}});
    }
  }
}

}  // namespace foldwright
