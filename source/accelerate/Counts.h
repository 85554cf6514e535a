#pragma once

#include <cstdint>

namespace ray {

/// What tracing cost, counted by each thread for itself and added up afterwards.
struct Counts {
  std::uint64_t box_tests = 0;        // rays against boxes of nodes
  std::uint64_t primitive_tests = 0;  // rays against elements of shapes
  std::uint64_t cache_tests = 0;      // of those, asked first because the last ray hit them
  std::uint64_t cache_hits = 0;       // and hit again

  Counts& operator+=(const Counts& o) {
    box_tests += o.box_tests, primitive_tests += o.primitive_tests;
    cache_tests += o.cache_tests, cache_hits += o.cache_hits;
    return *this;
  }
  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace ray
