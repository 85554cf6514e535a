#include "source/parse/CsgOf.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "R3/Csg.h"
#include "R3/Transform.h"
#include "source/scene/Singular.h"

namespace ray {
namespace {

using R3::CsgOperation, R3::CsgPart;

/// The transform from the csg to a node below it.
struct Frame {
  R3::Product csg_from_node;
  R3::Matrix magnitudes;  // the product of the magnitudes of the same matrices
  int links = 0;

  void Append(const R3::Matrix& matrix) {
    if (IsIdentity(matrix)) return;
    csg_from_node = csg_from_node * matrix;
    R3::Matrix product;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        product.m[i][j] = j == 3 ? magnitudes.m[i][3] : 0;
        for (std::size_t k = 0; k < 3; ++k) product.m[i][j] += magnitudes.m[i][k] * std::abs(matrix.m[k][j]);
      }
    magnitudes = product;
    ++links;
  }
};

/// Returns the slack of a solid. A link of a chain is a transform command, or a matrix printed by a program: every
/// entry is assumed to be off by eight roundings, as a product of three such commands is.
double SlackOf(const Frame& frame, const R3::Shape& solid) {
  const R3::Box box = Bounds(solid);
  if (frame.links == 0 || box.IsEmpty()) return 0;
  const auto reach = [&](int axis) { return std::max(std::abs(box.low[axis]), std::abs(box.high[axis])); };
  const R3::Point farthest{reach(0), reach(1), reach(2)};
  return R3::Gamma(8) * frame.links * MaxComponent(FromOrigin(frame.magnitudes * farthest));
}

CsgPart SolidOf(const Node& node, int parent, const Frame& frame, int material) {
  const auto transform = R3::Transform::Of(frame.csg_from_node);
  CsgPart part{.parent = parent, .material = material};
  if (!transform) return part;  // an empty union
  part.solid = node.shape;
  part.csg_from_solid = *transform;
  part.slack = SlackOf(frame, *node.shape);
  return part;
}

}  // namespace

// Not recursive: see Node.
std::shared_ptr<const R3::Shape> CsgOf(const Node& csg) {
  struct Waiting {
    const Node* node;
    int parent, material;
    Frame frame;
  };
  std::vector<CsgPart> parts;
  std::vector<Waiting> stack;
  stack.push_back({&csg, CsgPart::no_parent, CsgPart::no_material, {}});
  while (!stack.empty()) {
    Waiting next = stack.back();
    stack.pop_back();
    const Node& node = *next.node;
    if (node.shape) {
      parts.push_back(SolidOf(node, next.parent, next.frame, next.material));
      continue;
    }
    next.frame.Append(node.transform);
    int self = next.parent;
    // Groups without effect are skipped, so that a long chain of them does not slow down rays.
    const auto is_group_in = [&](CsgOperation operation) {
      return parts[static_cast<std::size_t>(self)].operation == operation;
    };
    const bool is_transparent = !node.operation && (node.children.size() == 1 || is_group_in(CsgOperation::unite));
    if (!is_transparent) {
      self = static_cast<int>(parts.size());
      parts.push_back({.parent = next.parent, .operation = node.operation.value_or(CsgOperation::unite)});
    }
    if (IsSingular(node.transform)) {
      if (is_transparent) parts.push_back({.parent = self});
      continue;
    }
    for (std::size_t i = node.children.size(); i-- > 0;) {
      const Node& child = node.children[i];
      stack.push_back({&child, self, child.material == Node::inherit ? next.material : child.material, next.frame});
    }
  }
  return std::make_shared<const R3::Csg>(std::move(parts));
}

}  // namespace ray
