#pragma once

#include <string>

namespace ray {

/// Which accelerator, and how.
struct AcceleratorSettings {
  std::string name = "graph";  // a line of accelerators.def
  // The three devices of `graph`, each with its own switch so that they can be compared. None changes a picture.
  bool node_boxes = true;      // skip nodes whose box the ray misses
  bool front_to_back = true;   // nearer children first, so that farther ones fall behind the hit
  bool last_hit = true;        // ask first what the last ray of the kind hit
  std::string instruction_set = "best";  // of `bvh`: one of bvh::InstructionSets(). Never changes a picture either
};

}  // namespace ray
