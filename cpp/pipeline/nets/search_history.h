#pragma once

#include <map>

#include "pipeline/stage.h"

namespace foldwright {

/// What is told of the searches of each part, one after the other: as one run of generations whose
/// best fitness never falls.
class SearchHistory {
 public:
  /// Appends an event for every generation of a part that `status` has news of, the last one with
  /// the net as it is.
  void tell(int part, const TaskStatus& status, Events& events);

 private:
  struct OfPart {
    int generations = 0;
    SearchStatus best{};
  };
  std::map<int, OfPart> parts_;
};

}  // namespace foldwright
