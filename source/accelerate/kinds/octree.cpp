#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "source/accelerate/Cells.h"

// Highway compiles this file once for each instruction set. What does not depend on that is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/kinds/octree.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "source/accelerate/Search-inl.h"

#ifndef RAY_ACCELERATE_OCTREE
#define RAY_ACCELERATE_OCTREE
namespace ray {

/// A cube halved along all three axes again and again, where that is worth it.
struct Octree {
  static constexpr bool meets_items_again = true;

  struct Node {
    static constexpr std::uint32_t none = 0;  // the root is nobody's child

    std::uint32_t first_child =
        none;           // of eight: bit 0 of a child's number is set on the far side in x, bit 1 in y, ...
    Contents contents;  // of a leaf
  };
  static constexpr double reach = 1 + 0x1p-10;  // of the cube, to either side
  static constexpr int most_depth = 40;

  explicit Octree(Space the_space) : space(std::move(the_space)) {}

  Space space;
  Coordinates coordinates;
  std::vector<Node> nodes;  // the root first
  CellContents contents;
  std::uint64_t references = 0;
  int depth = 0;

  std::size_t Bytes() const { return space.Bytes() + contents.Bytes() + nodes.capacity() * sizeof(Node); }
  std::string Explain() const {
    return std::to_string(nodes.size()) + " nodes in " + std::to_string(depth) + " levels, " +
           std::to_string(references) + " references";
  }
};

}  // namespace ray
#endif

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// A node that the ray is in: where it crosses the node's planes, and which child comes next.
struct Crossing {
  double enter[3], leave[3];
  std::uint32_t node;
  std::uint32_t child;
};

/// Children in the order of the ray, in space mirrored so that it goes up along all axes.
///   source  Revelles, Urena, Lastra, An efficient parametric algorithm for octree traversal (2000)
template <bool any, typename Asker>
void Walk(const Octree& tree, const Probe& probe, Asker& asker, Counts& counts) {
  if (tree.nodes.empty()) return;
  if (!(static_cast<double>(probe.slack) <= cell_pad / 2)) {
    AskContents(tree.contents, tree.contents.All(), asker);
    return;
  }
  Crossing stack[Octree::most_depth + 1];
  std::uint32_t mirror = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double steepness = std::max(std::abs(probe.along[axis]), 0x1p-40);
    const bool is_mirrored = std::signbit(probe.along[axis]);
    if (is_mirrored) mirror |= 1u << axis;
    const double start = is_mirrored ? -probe.start[axis] : probe.start[axis];
    stack[0].enter[axis] = (-Octree::reach - start) / steepness;
    stack[0].leave[axis] = (Octree::reach - start) / steepness;
  }
  stack[0].node = 0;
  std::uint64_t visits = 0;
  int top = 0;
  bool is_new = true;
  while (top >= 0) {
    Crossing& at = stack[top];
    const Octree::Node& node = tree.nodes[at.node];
    const auto middle = [&](int axis) { return 0.5 * (at.enter[axis] + at.leave[axis]); };
    if (is_new) {
      ++visits;
      const double enter = std::max({at.enter[0], at.enter[1], at.enter[2]});
      const double leave = std::min({at.leave[0], at.leave[1], at.leave[2]});
      if (leave < 0 || enter > leave) {  // behind the start, or passed by
        --top, is_new = false;
        continue;
      }
      if (enter > static_cast<double>(asker.limit)) break;  // and so is all that follows
      if (node.first_child == Octree::Node::none) {
        if (AskContents(tree.contents, node.contents, asker)) break;
        --top, is_new = false;
        continue;
      }
      at.child = (middle(0) < enter ? 1u : 0u) | (middle(1) < enter ? 2u : 0u) | (middle(2) < enter ? 4u : 0u);
    } else {
      // Out of the last child by the plane that comes first: into its neighbour there, or out of the node.
      int axis = 0;
      double first = R3::infinity;
      for (int a = 0; a < 3; ++a) {
        const double out = at.child >> a & 1 ? at.leave[a] : middle(a);
        if (out < first) first = out, axis = a;
      }
      if (first == R3::infinity || at.child >> axis & 1) {
        --top;
        continue;
      }
      at.child |= 1u << axis;
    }
    Crossing& next = stack[++top];
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_far = at.child >> axis & 1;
      next.enter[axis] = is_far ? middle(axis) : at.enter[axis];
      next.leave[axis] = is_far ? at.leave[axis] : middle(axis);
    }
    next.node = node.first_child + (at.child ^ mirror);
    is_new = true;
  }
  counts.node_visits += visits;
}

void ChooseOctree(Kernels<Octree>* kernels) { *kernels = CompiledKernels<Octree>(); }

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

HWY_EXPORT(ChooseOctree);

constexpr std::size_t usual_leaf = 24;  // bench/kernels: 16 to 32 are equally fast, 8 takes twice the memory
constexpr int usual_depth = 20;

class OctreeBuilder {
 public:
  OctreeBuilder(Octree& tree, std::size_t leaf, int depth)
      : tree_(tree), leaf_(leaf), depth_(std::min(depth, Octree::most_depth)) {}

  void Run() {
    const std::uint32_t count = tree_.space.Items();
    if (count == 0) return;
    tree_.coordinates = FitCoordinates(tree_.space);
    items_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) items_.emplace_back(tree_.space, tree_.coordinates, i);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    most_references_ = 12 * static_cast<std::uint64_t>(count) + 4096;
    open_references_ = count;
    tree_.nodes.emplace_back();
    constexpr double r = Octree::reach;
    // Breadth first: where memory runs out, it runs out everywhere at about the same size of cells.
    std::deque<Work> waiting;
    waiting.push_back({0, {R3::Point{-r, -r, -r}, R3::Point{r, r, r}}, std::move(all), 0});
    for (; !waiting.empty(); waiting.pop_front()) Divide(waiting.front(), waiting);
    tree_.contents.Close();
  }

 private:
  using List = std::vector<std::uint32_t>;

  struct Work {
    std::uint32_t node;
    Cell cell;
    List items;
    int depth;
  };

  void Divide(const Work& work, std::deque<Work>& waiting) {
    tree_.depth = std::max(tree_.depth, work.depth);
    std::array<List, 8> parts;
    if (work.items.size() > leaf_ && work.depth < depth_ && Part(work.cell, work.items, parts)) {
      const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes[work.node].first_child = first;
      tree_.nodes.resize(first + 8);
      for (std::uint32_t i = 0; i < 8; ++i)
        waiting.push_back({first + i, Octant(work.cell, i), std::move(parts[i]), work.depth + 1});
    } else {
      tree_.references += work.items.size();
      tree_.nodes[work.node].contents = tree_.contents.Add(tree_.space, tree_.coordinates, work.items);
    }
  }

  /// The items of each octant. False when it is not worth it: most items go into most octants, or memory would run out.
  bool Part(const Cell& cell, const List& items, std::array<List, 8>& parts) {
    std::size_t sum = 0;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Cell octant = Octant(cell, i);
      for (const std::uint32_t item : items)
        if (items_[item].MayTouch(octant)) parts[i].push_back(item);
      sum += parts[i].size();
    }
    constexpr std::size_t most_growth = 3;
    if (sum > most_growth * items.size() || open_references_ + sum - items.size() > most_references_) return false;
    open_references_ += sum - items.size();
    return true;
  }

  static Cell Octant(const Cell& cell, std::uint32_t i) {
    const R3::Vector half = 0.5 * (cell.high - cell.low);
    const R3::Point low = cell.low + R3::Vector{i & 1 ? half.x : 0, i & 2 ? half.y : 0, i & 4 ? half.z : 0};
    return {low, low + half};
  }

  Octree& tree_;
  std::size_t leaf_;
  int depth_;
  std::uint64_t most_references_ = 0, open_references_ = 0;
  std::vector<CellItem> items_;
};

}  // namespace

extern const AcceleratorKind octree_kind{
    "octree", "cubes within cubes",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      const std::size_t leaf = settings.resolution >= 1 ? static_cast<std::size_t>(settings.resolution) : usual_leaf;
      const int depth = settings.depth > 0 ? settings.depth : usual_depth;
      return std::make_unique<ForestAccelerator<Octree>>(
          world, settings,
          [](void* kernels) { HWY_DYNAMIC_DISPATCH(ChooseOctree)
                              (static_cast<Kernels<Octree>*>(kernels)); },
          [&](Space space) {
            Octree tree(std::move(space));
            OctreeBuilder(tree, leaf, depth).Run();
            return tree;
          });
    }};

}  // namespace ray
#endif
