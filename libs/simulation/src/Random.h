// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace toss::simulation {

/// Hash of a counter (the finalizer of splitmix64): random access to a random sequence, so that
/// results do not depend on the order in which threads ask for them.
inline std::uint64_t hash(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15ull;
  key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ull;
  key = (key ^ (key >> 27)) * 0x94D049BB133111EBull;
  return key ^ (key >> 31);
}

inline std::uint64_t hash(std::uint64_t key, std::uint64_t next) {
  return hash(hash(key) ^ next);
}

/// Uniform in [0, 1).
inline double uniformOf(std::uint64_t key) {
  return static_cast<double>(hash(key) >> 11) * 0x1.0p-53;
}

/// Mean 0, deviation 1: the sum of four uniform numbers, which needs no library function that
/// could differ between machines. Never beyond 3.47.
inline double gaussianOf(std::uint64_t key) {
  const std::uint64_t bits = hash(key);
  const std::uint64_t sum =
      (bits & 0xFFFFu) + ((bits >> 16) & 0xFFFFu) + ((bits >> 32) & 0xFFFFu) + (bits >> 48);
  return (static_cast<double>(sum) / 65535.0 - 2.0) * 1.7320508075688772;
}

/// Sequence of random numbers for building worlds.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : key_(hash(seed)) {}

  double uniform(double low, double high) {
    return low + (high - low) * uniformOf(key_ ^ ++count_);
  }
  double gaussian(double mean, double deviation) {
    return mean + deviation * gaussianOf(key_ ^ ++count_);
  }
  /// Whether something of that probability happens.
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// One of 0 .. count - 1.
  int index(int count) { return static_cast<int>(uniform(0.0, count)); }

 private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace toss::simulation
