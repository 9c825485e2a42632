#pragma once

#include <cstdint>

namespace foldwright {

/// Small seeded generator (xoshiro256**, seeded by splitmix64) with its own distributions.
///
/// The standard library's distributions differ between implementations; these give the same
/// numbers from the same seed everywhere, which reproducible results rest on.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  /// Uniform 64 bits.
  std::uint64_t bits();
  /// Uniform integer in [0, n). \pre n > 0
  int below(int n);
  /// Uniform real in [0, 1).
  double uniform();
  /// Standard normal deviate (Marsaglia's polar method).
  double normal();

 private:
  std::uint64_t state_[4];
};

/// Seed of a task: a hash of the job's seed and what names the task (stage, part, index).
/// Tasks never share a generator, so their order and the number of workers do not matter.
std::uint64_t task_seed(std::uint64_t seed, std::uint64_t stage, std::uint64_t part,
                        std::uint64_t index);

}  // namespace foldwright
