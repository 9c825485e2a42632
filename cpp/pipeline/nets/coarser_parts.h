#pragma once

#include "pipeline/state.h"

namespace foldwright {

/// Parts that came to so many pieces that the body that they are of may come to fewer as a whole,
/// as flat plates with holes do, whose rims hang together only when nothing parts them.
///
/// Trials begin when all parts have their nets. What they find counts only if it makes fewer
/// pieces, and at least as many as parts were asked for: each is a part then.
class CoarserParts {
 public:
  /// Takes the nets of such bodies out of the state and returns the regions to be searched instead.
  /// \pre every part has its nets in the state
  std::vector<Region> begin(JobState& state);

  bool trying() const { return !trials_.empty(); }

  /// Decides for each body what it keeps, and tells what it came to; true if parts have changed.
  bool end(JobState& state);

  /// Puts back what was taken out, when there is no time to find anything better.
  void abandon(JobState& state);

 private:
  struct Trial {
    int component;
    std::vector<FoundNet> parts;  ///< nets that were found first
  };
  std::vector<Trial> trials_;
};

}  // namespace foldwright
