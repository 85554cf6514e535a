#include "source/accelerate/wide/Tree.h"

namespace ray::bvh {

std::vector<R3::Box> Tree::BoxesAt(int level) const {
  if (level < 0 || level >= BoxLevels()) return {};
  std::vector<R3::Box> boxes;
  if (level == 0) {
    R3::Box all;  // a root that is a leaf has its box nowhere else
    if (Child::KindOf(root) == Child::Kind::node)
      for (const R3::Box& box : BoxesAt(1)) all.Extend(box);
    else
      for (std::uint32_t i = 0; i < space.Items(); ++i) all.Extend(space.Bounds(i));
    boxes.push_back(all);
    return boxes;
  }
  struct Waiting {
    std::uint32_t node;
    int level;  // of its children
  };
  std::vector<Waiting> stack;
  if (Child::KindOf(root) == Child::Kind::node) stack.push_back({root, 1});
  while (!stack.empty()) {
    const Waiting next = stack.back();
    stack.pop_back();
    const Node& node = At<Node>(next.node);
    for (int i = width; i-- > 0;) {
      if (Child::KindOf(node.child[i]) == Child::Kind::nothing) continue;
      const auto side = [&](int s) {
        return coordinates.Back({node.plane[s][i], node.plane[2 + s][i], node.plane[4 + s][i]});
      };
      if (next.level == level)
        boxes.push_back({side(0), side(1)});
      else if (Child::KindOf(node.child[i]) == Child::Kind::node)
        stack.push_back({node.child[i], next.level + 1});
    }
  }
  return boxes;
}

}  // namespace ray::bvh
