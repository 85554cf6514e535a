#pragma once

#include <cstdint>

namespace ray {

/// The costs of tracing, counted by each thread separately and added up afterwards.
struct Counts {
  std::uint64_t node_visits = 0;      // nodes, cells or leaves visited by rays
  std::uint64_t box_tests = 0;        // tests of rays against boxes of nodes
  std::uint64_t primitive_tests = 0;  // tests of rays against elements of shapes
  std::uint64_t cache_tests = 0;      // of these, tests made first because of the last ray's hit
  std::uint64_t cache_hits = 0;       // of these, tests that hit again
  std::uint64_t hits = 0;             // rays that hit something
  std::uint64_t bad_rays = 0;         // with NaN, infinity, zero direction or zero length: they hit nothing

  Counts& operator+=(const Counts& o) {
    node_visits += o.node_visits, hits += o.hits, bad_rays += o.bad_rays;
    box_tests += o.box_tests, primitive_tests += o.primitive_tests;
    cache_tests += o.cache_tests, cache_hits += o.cache_hits;
    return *this;
  }
  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace ray
