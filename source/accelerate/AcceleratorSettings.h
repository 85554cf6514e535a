#pragma once

#include <limits>
#include <string>

namespace ray {

/// Which accelerator, and how.
struct AcceleratorSettings {
  std::string name = "auto";  // a line of accelerators.def
  // The three devices of `graph`, each with its own switch so that they can be compared. None changes a picture.
  bool node_boxes = true;     // skip nodes whose box the ray misses
  bool front_to_back = true;  // nearer children first, so that farther ones fall behind the hit
  bool last_hit = true;       // test first what the last ray of the kind hit
  // How fine a structure is: cells a primitive of `grid`, primitives a leaf of `octree`, triangles a leaf of `bvh`.
  double resolution = 0;  // 0: what is best for most scenes
  int depth = 0;          // levels of `octree`, at most most_octree_levels; 0: what is best for most scenes
  std::string instruction_set = "best";  // of `bvh`: one of InstructionSets()

  // What `auto` needs to know to weigh a build against what it saves.
  double expected_rays = 1e6;
  // `grid` throws BuildTookTooLong when its build takes longer, which the slivers around a vertex make it do.
  double most_build_seconds = std::numeric_limits<double>::infinity();

  friend bool operator==(const AcceleratorSettings&, const AcceleratorSettings&) = default;
};

struct BuildTookTooLong {};

/// Cubes are then far smaller than what boxes in single precision resolve, and traversal still has stack enough.
inline constexpr int most_octree_levels = 40;

}  // namespace ray
