#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "source/scene/Node.h"

namespace graph {

/// How many nodes have a box on each level of a scene graph, the root's being 0. Does not recurse: graphs may be deep.
inline std::vector<std::int64_t> NodesWithBoxes(const ray::Node& root) {
  std::vector<std::int64_t> counts;
  for (std::vector<const ray::Node*> level{&root}, next; !level.empty(); level = std::exchange(next, {})) {
    counts.push_back(0);
    for (const ray::Node* node : level) {
      if (!node->bounds.IsEmpty()) ++counts.back();
      for (const ray::Node& child : node->children) next.push_back(&child);
    }
  }
  return counts;
}

}  // namespace graph
