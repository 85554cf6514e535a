#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <vector>

#include "source/accelerate/wide/Kernels.h"
#include "source/accelerate/wide/Parts.h"

namespace ray {
namespace {

using bvh::box_rounding;
using bvh::BuildChild;
using bvh::BuildNode;
using bvh::Part;
using bvh::Parts;

// A node of full blocks; fewer are slower and take twice the memory (bench/kernels).
constexpr std::size_t usual_leaf = 64;
constexpr int usual_depth = 20;

struct Cube {
  R3::Point middle;
  double half = 1;

  R3::Box Box() const {
    const R3::Vector sides{half, half, half};
    return {middle - sides, middle + sides};
  }
  Cube Octant(unsigned i) const {
    const double h = half / 2;
    return {middle + R3::Vector{i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h}, h};
  }
};

/// A cube halved along all three axes again and again, where that is worth it. An octant is known by the box of what
/// lies in it, not by its own: boxes of octants do not overlap, and are visited from front to back, eight tested at a
/// time by the walk that all trees of boxes share. Chains of nodes with a single octant are left out.
///   source  Glassner, PrimitiveSet subdivision for fast ray tracing (1984)
class OctreeBuilder {
 public:
  OctreeBuilder(bvh::Tree& tree, std::size_t leaf, int depth)
      : tree_(tree), leaf_(leaf), depth_(std::min(depth, most_octree_levels)) {}

  void Run() {
    const std::uint32_t count = tree_.space.Items();
    if (count == 0) return;
    tree_.coordinates = FitCoordinates(tree_.space);
    Parts all(count);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) { all[i] = WholePart(tree_, i); });
    // Beyond 1, so that nothing is rounded out of it.
    const BuildChild root = Divide(std::move(all), {R3::Point{}, 1 + 0x1p-10}, 0, most_growth);
    tree_.root = bvh::Flatten({&root, 1}, tree_)[0];
  }

 private:
  // Memory is bounded by how often items may be referred to: in all, and by one division.
  static constexpr double most_growth = 8, most_growth_at_once = 3;
  static constexpr std::size_t parallel_from = 4096;

  /// `growth` is how many times as many references may be made of these.
  BuildChild Divide(Parts parts, const Cube& cube, int depth, double growth) {
    if (parts.size() <= leaf_ || depth >= depth_) return group_(parts);
    std::array<Parts, 8> octants;
    for (const Part& part : parts) Distribute(part, cube, octants);
    std::size_t sum = 0, filled = 0, last = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      sum += octants[i].size();
      if (!octants[i].empty()) ++filled, last = i;
    }
    const double grown = static_cast<double>(sum) / static_cast<double>(parts.size());
    if (grown > std::min(growth, most_growth_at_once)) return group_(parts);
    parts = {};
    if (filled == 1)
      return Divide(std::move(octants[last]), cube.Octant(static_cast<unsigned>(last)), depth + 1, growth / grown);

    std::array<BuildChild, 8> slots;
    tbb::task_group tasks;
    for (std::size_t i = 0; i < 8; ++i) {
      if (octants[i].empty()) continue;
      const auto divide = [&, i] {
        slots[i] = Divide(std::move(octants[i]), cube.Octant(static_cast<unsigned>(i)), depth + 1, growth / grown);
      };
      if (octants[i].size() >= parallel_from)
        tasks.run(divide);
      else
        divide();
    }
    tasks.wait();
    BuildNode& draft = group_.NewDraft();
    for (const BuildChild& slot : slots)
      if (!slot.IsEmpty()) draft.Add(slot);
    return BuildChildOf(draft);
  }

  /// Into the octants that the part reaches, cut where it is a triangle.
  void Distribute(const Part& part, const Cube& cube, std::array<Parts, 8>& octants) const {
    unsigned below = 0, above = 0;  // axes, as bits, along which it reaches to either side of the middle
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = FromOrigin(cube.middle)[axis];
      if (part.box.low[axis] - box_rounding <= middle) below |= 1u << axis;
      if (part.box.high[axis] + box_rounding >= middle) above |= 1u << axis;
    }
    for (unsigned i = 0; i < 8; ++i) {
      if ((i & ~above) != 0 || (~i & 7 & ~below) != 0) continue;
      const bool is_whole = (i & below) == 0 && (~i & 7 & above) == 0;
      Part inside = part;
      if (!is_whole && !CutTo(cube.Octant(i).Box(), tree_, inside)) continue;
      octants[i].push_back(inside);
    }
  }

  bvh::Tree& tree_;
  std::size_t leaf_;
  int depth_;
  bvh::Grouping group_;
};

}  // namespace

extern const AcceleratorKind octree_kind{
    "octree", "cubes within cubes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      const std::size_t leaf = settings.resolution >= 1 ? static_cast<std::size_t>(settings.resolution) : usual_leaf;
      const int depth = settings.depth > 0 ? settings.depth : usual_depth;
      return std::make_unique<TwoLevelAccelerator<bvh::Tree>>(world, settings, bvh::ChooseKernels,
                                                              [&](PrimitiveSet space) {
                                                                bvh::Tree tree(std::move(space));
                                                                OctreeBuilder(tree, leaf, depth).Run();
                                                                return tree;
                                                              });
    }};

}  // namespace ray
