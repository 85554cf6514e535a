#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace ray {

inline double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Measures the wall-clock time of work.
template <typename Work>
double SecondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return SecondsSince(start);
}

/// Returns the least of several attempts: the first one may have to initialize data, and others may have to wait for a
/// processor or for memory.
template <typename Work>
double LeastSecondsOf(int attempts, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < attempts; ++i) least = std::min(least, SecondsOf(work));
  return least;
}

}  // namespace ray
