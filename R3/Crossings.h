#pragma once

#include <array>
#include <cstddef>

#include "R3/Hit.h"

namespace R3 {

/// The first crossings of a ray with an element, in ascending order of t.
struct Crossings {
  static constexpr std::size_t most = 4;

  std::array<Hit, most> hits;  // the first `count` are set
  std::size_t count = 0;
  bool may_have_more = false;  // there may be further crossings after these

  void Add(const Hit& hit) { hits[count++] = hit; }
};

}  // namespace R3
