#include "geometry/random.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <initializer_list>

namespace foldwright {
namespace {

// Constants of splitmix64 (Steele, Lea, Flood 2014) and xoshiro256** (Blackman, Vigna 2018).
std::uint64_t splitmix(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed) {
  for (auto& word : state_) word = splitmix(seed);
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

int Random::below(int n) {
  assert(n > 0);
  // Multiply-shift on the upper half; the bias is below n / 2^32, far under what any use here sees.
  return static_cast<int>(((bits() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double Random::normal() {
  while (true) {
    const double x = 2 * uniform() - 1;
    const double y = 2 * uniform() - 1;
    const double square = x * x + y * y;
    // The pair's second deviate is let go, so that the generator's state stays its four words.
    if (square > 0 && square < 1) return x * std::sqrt(-2 * std::log(square) / square);
  }
}

std::uint64_t task_seed(std::uint64_t seed, SeedTag tag, std::uint64_t part, std::uint64_t index) {
  std::uint64_t state = seed;
  for (const std::uint64_t word : {static_cast<std::uint64_t>(tag), part, index})
    state = splitmix(state) ^ word;
  return splitmix(state);
}

}  // namespace foldwright
