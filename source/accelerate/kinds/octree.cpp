#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "source/accelerate/bvh/Kernels.h"
#include "source/accelerate/bvh/Layout.h"

namespace ray {
namespace {

using bvh::Draft;
using bvh::Extent;
using bvh::Float4;
using bvh::Least;
using bvh::Most;
using bvh::Slot;

constexpr std::size_t usual_leaf =
    64;  // a node of full blocks; fewer are slower and take twice the memory (bench/kernels)
constexpr int usual_depth = 20, most_depth = 40;

/// Of one item, what lies in one octant.
struct Part {
  Extent box;
  std::uint32_t item = 0;
  bool is_triangle = false;
};
using Parts = std::vector<Part>;

struct Cube {
  R3::Point middle;
  double half = 1;

  Cube Octant(unsigned i) const {
    const double h = half / 2;
    return {middle + R3::Vector{i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h}, h};
  }
};

Float4 Floats(const R3::Vector& v) {
  return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}

/// The box of what is left of a triangle inside the cube; false when nothing is.
///   source  Sutherland, Hodgman, Reentrant polygon clipping (1974)
bool BoxWithin(const Cube& cube, const std::array<R3::Vector, 3>& corners, Extent& box) {
  std::array<R3::Vector, 9> polygon{corners[0], corners[1], corners[2]}, cut;
  std::size_t count = 3;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto inside = [&](const R3::Vector& p) {  // by how much
        return cube.half - side * (p[axis] - FromOrigin(cube.middle)[axis]);
      };
      std::size_t kept = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const R3::Vector &a = polygon[i], &b = polygon[(i + 1) % count];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) cut[kept++] = a;
        if ((at_a < 0) != (at_b < 0)) cut[kept++] = a + at_a / (at_a - at_b) * (b - a);
      }
      polygon = cut, count = kept;
    }
  if (count == 0) return false;
  box = {};
  for (std::size_t i = 0; i < count; ++i) box.Extend(Floats(polygon[i]));
  return true;
}

/// A cube halved along all three axes again and again, where that is worth it. An octant is known by the box of what
/// lies in it, not by its own: boxes of octants do not overlap, and are visited from front to back, eight tested at a
/// time by the walk that all trees of boxes share. Chains of nodes with a single octant are left out.
///   source  Glassner, Space subdivision for fast ray tracing (1984)
class OctreeBuilder {
 public:
  OctreeBuilder(bvh::Tree& tree, std::size_t leaf, int depth)
      : tree_(tree), leaf_(leaf), depth_(std::min(depth, most_depth)) {}

  void Run() {
    const std::uint32_t count = tree_.space.Items();
    if (count == 0) return;
    tree_.coordinates = FitCoordinates(tree_.space);
    Parts all(count);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) { all[i] = Whole(i); });
    // Beyond 1, so that nothing is rounded out of it.
    const Slot root = Divide(std::move(all), {R3::Point{}, 1 + 0x1p-10}, 0, most_growth);
    Draft draft;
    draft.Add(root);
    bvh::Lay(root.below ? *root.below : draft, tree_);
  }

 private:
  // Memory is bounded by how often items may be referred to: in all, and by one division.
  static constexpr double most_growth = 8, most_growth_at_once = 3;
  static constexpr std::size_t parallel_from = 4096;
  /// Of boxes to floats, which are at most 1, twice over; cells need not be smaller.
  static constexpr float rounding = 0x1p-22f;

  Part Whole(std::uint32_t item) const {
    const R3::Box bounds = tree_.space.Bounds(item);
    return {{Floats(tree_.coordinates(bounds.low)), Floats(tree_.coordinates(bounds.high))},
            item,
            tree_.space.MeshOf(item) != nullptr};
  }

  /// `growth` is how many times as many references may be made of these.
  Slot Divide(Parts parts, const Cube& cube, int depth, double growth) {
    if (parts.size() <= leaf_ || depth >= depth_) return Group(parts);
    std::array<Parts, 8> octants;
    for (const Part& part : parts) Distribute(part, cube, octants);
    std::size_t sum = 0, filled = 0, last = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      sum += octants[i].size();
      if (!octants[i].empty()) ++filled, last = i;
    }
    const double grown = static_cast<double>(sum) / static_cast<double>(parts.size());
    if (grown > std::min(growth, most_growth_at_once)) return Group(parts);
    parts = {};
    if (filled == 1)
      return Divide(std::move(octants[last]), cube.Octant(static_cast<unsigned>(last)), depth + 1, growth / grown);

    std::array<Slot, 8> slots;
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
    Draft& draft = NewDraft();
    for (const Slot& slot : slots)
      if (slot.below || slot.triangles > 0 || !IsEmpty(slot)) draft.Add(slot);
    return SlotOf(draft);
  }

  static bool IsEmpty(const Slot& slot) { return slot.box.low[0] > slot.box.high[0]; }

  /// Into the octants that the part reaches, cut where it is a triangle.
  void Distribute(const Part& part, const Cube& cube, std::array<Parts, 8>& octants) const {
    unsigned below = 0, above = 0;  // axes, as bits, along which it reaches to either side of the middle
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = FromOrigin(cube.middle)[axis];
      if (part.box.low[axis] - rounding <= middle) below |= 1u << axis;
      if (part.box.high[axis] + rounding >= middle) above |= 1u << axis;
    }
    for (unsigned i = 0; i < 8; ++i) {
      if ((i & ~above) != 0 || (~i & 7 & ~below) != 0) continue;
      const bool is_whole = (i & below) == 0 && (~i & 7 & above) == 0;
      Part inside = part;
      if (!is_whole && !Cut(inside, cube.Octant(i))) continue;
      octants[i].push_back(inside);
    }
  }

  /// False when nothing of it lies in the octant.
  bool Cut(Part& part, const Cube& octant) const {
    const R3::Vector half{octant.half, octant.half, octant.half};
    Extent box{Floats(FromOrigin(octant.middle) - half), Floats(FromOrigin(octant.middle) + half)};
    if (part.is_triangle) {
      const auto corners = tree_.space.MeshOf(part.item)->Corners(tree_.space[part.item].element);
      const std::array placed{tree_.coordinates(corners[0]), tree_.coordinates(corners[1]),
                              tree_.coordinates(corners[2])};
      if (!BoxWithin(octant, placed, box)) return false;
    }
    part.box.low = Most(part.box.low, box.low - rounding), part.box.high = Least(part.box.high, box.high + rounding);
    for (int axis = 0; axis < 3; ++axis)
      if (part.box.low[axis] > part.box.high[axis]) return false;
    return true;
  }

  /// A leaf: blocks of triangles that lie next to each other along its longest side, and other items by themselves.
  Slot Group(Parts& parts) {
    Extent box;
    for (const Part& part : parts) box.Extend(part.box);
    const Float4 size = box.high - box.low;
    int axis = size[1] > size[0] ? 1 : 0;
    if (size[2] > size[axis]) axis = 2;
    std::sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) {
      if (a.is_triangle != b.is_triangle) return a.is_triangle;
      const float x = a.box.low[axis] + a.box.high[axis], y = b.box.low[axis] + b.box.high[axis];
      return x != y ? x < y : a.item < b.item;
    });
    std::vector<Slot> slots;
    for (std::size_t i = 0; i < parts.size();) {
      Slot& slot = slots.emplace_back();
      do {
        slot.box.Extend(parts[i].box);
        slot.items[static_cast<std::size_t>(slot.triangles)] = parts[i].item;
        if (!parts[i].is_triangle) {
          ++i;
          break;
        }
        ++slot.triangles, ++i;
      } while (slot.triangles < width && i < parts.size() && parts[i].is_triangle);
    }
    return Group(slots);
  }

  Slot Group(std::span<const Slot> slots) {
    if (slots.size() == 1) return slots[0];
    Draft& draft = NewDraft();
    const std::size_t share = std::max<std::size_t>(1, (slots.size() + width - 1) / width);
    for (std::size_t i = 0; i < slots.size(); i += share)
      draft.Add(Group(slots.subspan(i, std::min(share, slots.size() - i))));
    return SlotOf(draft);
  }

  Draft& NewDraft() { return drafts_.local().emplace_back(); }
  static Slot SlotOf(const Draft& draft) {
    Slot slot;
    slot.below = &draft;
    for (int i = 0; i < draft.children; ++i) slot.box.Extend(draft.slots[static_cast<std::size_t>(i)].box);
    return slot;
  }

  bvh::Tree& tree_;
  std::size_t leaf_;
  int depth_;
  tbb::enumerable_thread_specific<std::deque<Draft>> drafts_;  // a deque keeps its elements in place
};

}  // namespace

extern const AcceleratorKind octree_kind{
    "octree", "cubes within cubes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      const std::size_t leaf = settings.resolution >= 1 ? static_cast<std::size_t>(settings.resolution) : usual_leaf;
      const int depth = settings.depth > 0 ? settings.depth : usual_depth;
      return std::make_unique<ForestAccelerator<bvh::Tree>>(world, settings, bvh::ChooseKernels, [&](Space space) {
        bvh::Tree tree(std::move(space));
        OctreeBuilder(tree, leaf, depth).Run();
        return tree;
      });
    }};

}  // namespace ray
