#include "source/scene/Node.h"

#include <iterator>
#include <utility>


namespace ray {

// Children are removed from the tree level by level, so that destructors are never nested more than one level deep: a
// tree 100,000 levels deep must not need 100,000 stack frames.
Node::~Node() {
  std::vector<Node> waiting = std::move(children);
  while (!waiting.empty()) {
    std::vector<Node> grandchildren = std::move(waiting.back().children);
    waiting.pop_back();
    std::move(grandchildren.begin(), grandchildren.end(), std::back_inserter(waiting));
  }
}

Node& Node::operator=(Node&& other) noexcept {
  if (this == &other) return *this;
  Node dying;  // takes the contents of this node and releases them without recursion
  dying.children = std::move(children);
  motion = other.motion;
  transform = other.transform;
  shape = std::move(other.shape);
  line = std::move(other.line);
  material = other.material;
  operation = other.operation;
  bounds = other.bounds;
  location = other.location;
  children = std::move(other.children);
  return *this;
}

void SetBounds(Node& node) {
  R3::Box box;
  if (node.shape) box.Extend(Bounds(*node.shape));
  if (node.line) {
    box.Extend(node.line->start);
    box.Extend(node.line->end);
  }
  if (!node.shape)
    for (const Node& child : node.children) box.Extend(child.bounds);
  node.bounds = {};
  if (box.IsEmpty()) return;
  for (int i = 0; i < 8; ++i) node.bounds.Extend(node.transform * box.Corner(i));
  node.bounds = Along(node.bounds, node.motion);
}

}  // namespace ray
