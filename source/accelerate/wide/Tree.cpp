#include "source/accelerate/wide/Tree.h"

namespace ray::wide {

std::vector<R3::Box> Tree::BoxesAt(int level) const {
  if (level < 0 || level >= BoxLevels()) return {};
  std::vector<R3::Box> boxes;
  if (level == 0) {
    R3::Box all;  // the box of a root that is a leaf is stored nowhere else
    if (Child::KindOf(root) == Child::Kind::node)
      for (const R3::Box& box : BoxesAt(1)) all.Extend(box);
    else
      for (std::uint32_t i = 0; i < primitives.Size(); ++i) all.Extend(primitives.Bounds(i));
    boxes.push_back(all);
    return boxes;
  }
  struct StackEntry {
    std::uint32_t node;
    int level;  // of its children
  };
  std::vector<StackEntry> stack;
  if (Child::KindOf(root) == Child::Kind::node) stack.push_back({root, 1});
  while (!stack.empty()) {
    const StackEntry next = stack.back();
    stack.pop_back();
    const Node& node = At<Node>(next.node);
    for (int i = width; i-- > 0;) {
      if (Child::IsNothing(node.child[i])) continue;
      const auto side = [&](int s) { return coordinates.Back({node.At(s, i), node.At(2 + s, i), node.At(4 + s, i)}); };
      if (next.level == level)
        boxes.push_back({side(0), side(1)});
      else if (Child::KindOf(node.child[i]) == Child::Kind::node)
        stack.push_back({node.child[i], next.level + 1});
    }
  }
  return boxes;
}

}  // namespace ray::wide
