#pragma once

#include <limits>
#include <string>

namespace ray {

/// Settings of the acceleration structure.
struct AcceleratorSettings {
  std::string name = "auto";  // a line of accelerators.def
  // The three optimizations of `graph`, which can be switched separately for comparison. None changes an image.
  bool node_boxes = true;     // skip nodes whose box the ray misses
  bool front_to_back = true;  // nearer children first, so that farther ones fall behind the hit
  bool last_hit = true;       // test first what the last ray of the kind hit
  // The granularity of a structure: cells per primitive of `grid`, primitives per leaf of `octree`, triangles per leaf
  // of `bvh`.
  double resolution = 0;  // 0: the best value for most scenes
  int depth = 0;          // levels of `octree`, at most most_octree_levels; 0: the best value for most scenes
  std::string instruction_set = "best";  // of `bvh`: one of InstructionSets()

  // The inputs by which `auto` weighs the time of a build against its benefit.
  double expected_rays = 1e6;
  // If a build of `grid` takes longer, it throws BuildTookTooLong; the slivers around a vertex can cause that.
  double most_build_seconds = std::numeric_limits<double>::infinity();

  friend bool operator==(const AcceleratorSettings&, const AcceleratorSettings&) = default;
};

struct BuildTookTooLong {};

/// The maximum number of levels. At that depth cubes are far smaller than what boxes in single precision resolve, and
/// the traversal stack still suffices.
inline constexpr int most_octree_levels = 40;

}  // namespace ray
