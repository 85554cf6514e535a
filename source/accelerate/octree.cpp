#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>

#include "source/accelerate/wide/ClippedPrimitive.h"
#include "source/accelerate/wide/Kernels.h"

namespace ray {
namespace {

using wide::box_rounding;
using wide::BuildChild;
using wide::BuildNode;
using wide::ClippedPrimitive;
using wide::ClippedPrimitives;

// One node of full blocks; smaller leaves are slower and take twice the memory (bench/kernels).
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

/// A builder of octrees: cubes halved along all three axes repeatedly, where that pays. An octant is represented by the
/// box of its contents, not by its cube: the boxes of octants do not overlap, and are visited from front to back, eight
/// tested at a time by the traversal that all wide trees share. Chains of nodes with a single octant are collapsed.
///   source  Glassner, Space subdivision for fast ray tracing (1984)
class OctreeBuilder {
 public:
  OctreeBuilder(wide::Tree& tree, std::size_t leaf, int depth)
      : tree_(tree), leaf_(leaf), depth_(std::min(depth, most_octree_levels)) {}

  void Run() {
    const std::uint32_t count = tree_.primitives.Size();
    if (count == 0) return;
    tree_.coordinates = FitCoordinates(tree_.primitives);
    ClippedPrimitives all(count);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) { all[i] = Unclipped(tree_, i); });
    // Slightly larger than 1, so that rounding excludes nothing.
    const BuildChild root = Divide(std::move(all), {R3::Point{}, 1 + 0x1p-10}, 0, most_growth);
    tree_.root = wide::Flatten({&root, 1}, tree_)[0];
  }

 private:
  // Memory is bounded by limits on the references per primitive: in total, and per division.
  static constexpr double most_growth = 8, most_growth_at_once = 3;
  static constexpr std::size_t parallel_from = 4096;

  /// Divides the primitives; `growth` limits the references made per given primitive.
  BuildChild Divide(ClippedPrimitives primitives, const Cube& cube, int depth, double growth) {
    if (primitives.size() <= leaf_ || depth >= depth_) return subtrees_.Build(primitives);
    std::array<ClippedPrimitives, 8> octants;
    for (const ClippedPrimitive& primitive : primitives) Distribute(primitive, cube, octants);
    std::size_t sum = 0, filled = 0, last = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      sum += octants[i].size();
      if (!octants[i].empty()) ++filled, last = i;
    }
    const double grown = static_cast<double>(sum) / static_cast<double>(primitives.size());
    if (grown > std::min(growth, most_growth_at_once)) return subtrees_.Build(primitives);
    primitives = {};
    if (filled == 1)
      return Divide(std::move(octants[last]), cube.Octant(static_cast<unsigned>(last)), depth + 1, growth / grown);

    std::array<BuildChild, 8> children;
    tbb::task_group tasks;
    for (std::size_t i = 0; i < 8; ++i) {
      if (octants[i].empty()) continue;
      const auto divide = [&, i] {
        children[i] = Divide(std::move(octants[i]), cube.Octant(static_cast<unsigned>(i)), depth + 1, growth / grown);
      };
      if (octants[i].size() >= parallel_from)
        tasks.run(divide);
      else
        divide();
    }
    tasks.wait();
    BuildNode& node = subtrees_.NewNode();
    for (const BuildChild& child : children)
      if (!child.IsEmpty()) node.Add(child);
    return ChildOf(node);
  }

  /// Distributes a primitive to the octants that it reaches, clipped if it is a triangle.
  void Distribute(const ClippedPrimitive& primitive, const Cube& cube,
                  std::array<ClippedPrimitives, 8>& octants) const {
    unsigned below = 0, above = 0;  // axes, as bits, along which it reaches to either side of the middle
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = FromOrigin(cube.middle)[axis];
      if (primitive.box.low[axis] - box_rounding <= middle) below |= 1u << axis;
      if (primitive.box.high[axis] + box_rounding >= middle) above |= 1u << axis;
    }
    for (unsigned i = 0; i < 8; ++i) {
      if ((i & ~above) != 0 || (~i & 7 & ~below) != 0) continue;
      const bool is_whole = (i & below) == 0 && (~i & 7 & above) == 0;
      ClippedPrimitive inside = primitive;
      if (!is_whole && !ClipTo(cube.Octant(i).Box(), tree_, inside)) continue;
      octants[i].push_back(inside);
    }
  }

  wide::Tree& tree_;
  std::size_t leaf_;
  int depth_;
  wide::SubtreeBuilder subtrees_;
};

}  // namespace

extern const AcceleratorKind octree_kind{
    "octree", "cubes within cubes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<Accelerator> {
      const std::size_t leaf = settings.resolution >= 1 ? static_cast<std::size_t>(settings.resolution) : usual_leaf;
      const int depth = settings.depth > 0 ? settings.depth : usual_depth;
      return std::make_unique<TwoLevelAccelerator<wide::Tree>>(world, settings, wide::ChooseKernels,
                                                               [&](PrimitiveSet primitives) {
                                                                 wide::Tree tree(std::move(primitives));
                                                                 OctreeBuilder(tree, leaf, depth).Run();
                                                                 return tree;
                                                               });
    }};

}  // namespace ray
