#include "pipeline/search_notices.h"

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
  for (const FoundNet& net : state.nets) {
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
    const std::string name = "part " + std::to_string(part + 1);
    if (outcome.pieces > 1) {
      const std::string lack =
          outcome.cause == Cause::kNoMotion ? " does not fold up" : " has no net";
      state.notices.push_back({"part-split", name + lack + " in one piece and became " +
                                                 std::to_string(outcome.pieces) + " pieces"});
    }
    if (outcome.meets_itself) {
      state.notices.push_back(
          {"meets-itself", name + " has faces that run through each other in "
                                  "the model, so no folding of it is free of collisions"});
    } else if (outcome.without_motion > 0) {
      state.notices.push_back(
          {"no-motion", "no way was found to fold up " + name +
                            " in one go without faces running into each other"});
    }
  }
}

}  // namespace foldwright
