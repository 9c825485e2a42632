#pragma once

#include "pipeline/job.h"

namespace foldwright::testing {

/// What a result leaves to glue.
struct SeamCounts {
  int seams = 0;
  double glue = 0;  ///< length of all seams, mm
  /// How many flaps follow another one in a chain, and how many of these are on the other side of
  /// it; between two pieces, and within one.
  struct Turns {
    int followers = 0, changes = 0;
  } between, within;
};

SeamCounts count_seams(const JobResult& result);

}  // namespace foldwright::testing
