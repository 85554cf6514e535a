#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "source/accelerate/Counts.h"

namespace ray {

/// The state of one thread that persists between rays: its counts, its last hits, memory for stacks. Reset at the start
/// of a tile, so that counts do not depend on which thread takes which tile.
struct Workspace {
  struct LastHit {
    std::uint32_t instance = 0;
    int element = 0;
  };
  struct StackEntry {
    double entry = 0;  // t at which the ray enters the node's box
    std::uint32_t node = 0;
  };

  Counts counts;
  std::optional<LastHit> last_hit, last_occluder;
  std::vector<StackEntry> stack;

  void ForgetLastHits() { last_hit.reset(), last_occluder.reset(); }
};

}  // namespace ray
