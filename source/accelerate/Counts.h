#pragma once

#include <cstdint>

namespace ray {

/// What tracing cost, counted by each thread for itself and added up afterwards.
struct Counts {
  std::uint64_t node_visits = 0;      // nodes, cells or leaves that rays went through
  std::uint64_t box_tests = 0;        // rays against boxes of nodes
  std::uint64_t primitive_tests = 0;  // rays against elements of shapes
  std::uint64_t cache_tests = 0;      // of those, made first because the last ray hit them
  std::uint64_t cache_hits = 0;       // and hit again
  std::uint64_t hits = 0;             // rays that hit something
  std::uint64_t bad_rays = 0;         // with NaN, infinity, no direction or no length: they hit nothing

  Counts& operator+=(const Counts& o) {
    node_visits += o.node_visits, hits += o.hits, bad_rays += o.bad_rays;
    box_tests += o.box_tests, primitive_tests += o.primitive_tests;
    cache_tests += o.cache_tests, cache_hits += o.cache_hits;
    return *this;
  }
  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace ray
