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

/// What a generator is for: tells seeds apart that come from one job's seed.
enum class SeedTag : std::uint64_t {
  kComponent = 0,   ///< all learning about a component
  kLearning = 1,    ///< an unfolding within it
  kClustering = 2,  ///< a restart of k-means
  kSearch = 3,      ///< an attempt at a net, and the region that it is for
  kExchange = 4,    ///< an exchange of borders
  kPlanning = 5,    ///< a motion that is not straight
  kAnnealing = 6    ///< a net that is made better to craft
};

/// Seed of a task: a hash of the job's seed and what names the task (what it is for, part, index).
/// Tasks never share a generator, so their order and the number of workers do not matter.
std::uint64_t task_seed(std::uint64_t seed, SeedTag tag, std::uint64_t part, std::uint64_t index);

}  // namespace foldwright
