#include "source/accelerate/wide/ClippedPrimitive.h"

#include <algorithm>

namespace ray::wide {
namespace {

Float4 Floats(const R3::Vector& v) {
  return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}

/// Computes the box of the part of a triangle inside the cell; returns false if it is empty.
bool ClippedBounds(const R3::Box& cell, const std::array<R3::Vector, 3>& corners, Extent& box) {
  std::array<R3::Vector, 9> polygon{corners[0], corners[1], corners[2]}, cut;
  std::size_t count = 3;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const R3::Vector end = FromOrigin(side < 0 ? cell.low : cell.high);
      const auto inside = [&](const R3::Vector& p) { return side * (end[axis] - p[axis]); };  // signed distance
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

}  // namespace

ClippedPrimitive Unclipped(const Tree& tree, std::uint32_t primitive) {
  const R3::Box bounds = tree.primitives.Bounds(primitive);
  return {{Floats(tree.coordinates(bounds.low)), Floats(tree.coordinates(bounds.high))},
          primitive,
          LeafKindOf(tree, primitive)};
}

bool ClipTo(const R3::Box& cell, const Tree& tree, ClippedPrimitive& clipped) {
  Extent box{Floats(FromOrigin(cell.low)), Floats(FromOrigin(cell.high))};
  if (clipped.kind == Child::Kind::triangles) {
    const auto corners = tree.primitives.MeshOf(clipped.primitive)->Corners(tree.primitives[clipped.primitive].element);
    const std::array triangle{tree.coordinates(corners[0]), tree.coordinates(corners[1]), tree.coordinates(corners[2])};
    if (!ClippedBounds(cell, triangle, box)) return false;
  }
  clipped.box.low = Most(clipped.box.low, box.low - box_rounding);
  clipped.box.high = Least(clipped.box.high, box.high + box_rounding);
  for (int axis = 0; axis < 3; ++axis)
    if (clipped.box.low[axis] > clipped.box.high[axis]) return false;
  return true;
}

BuildChild SubtreeBuilder::Build(std::span<ClippedPrimitive> primitives) {
  if (primitives.empty()) return {};
  Extent box;
  for (const ClippedPrimitive& primitive : primitives) box.Extend(primitive.box);
  const Float4 size = box.high - box.low;
  int axis = size[1] > size[0] ? 1 : 0;
  if (size[2] > size[axis]) axis = 2;
  std::sort(primitives.begin(), primitives.end(), [&](const ClippedPrimitive& a, const ClippedPrimitive& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    const float x = a.box.low[axis] + a.box.high[axis], y = b.box.low[axis] + b.box.high[axis];
    return x != y ? x < y : a.primitive < b.primitive;
  });
  std::vector<BuildChild> children;
  for (const ClippedPrimitive& primitive : primitives) {
    const auto has_room = [&](const BuildChild& leaf) {
      return leaf.kind == primitive.kind && static_cast<std::uint32_t>(leaf.count) < MostOf(leaf.kind);
    };
    const bool is_next = !children.empty() && has_room(children.back());
    BuildChild& child = is_next ? children.back() : children.emplace_back();
    child.kind = primitive.kind;
    child.box.Extend(primitive.box);
    child.primitives[static_cast<std::size_t>(child.count++)] = primitive.primitive;
  }
  return Group(children);
}

BuildChild SubtreeBuilder::Group(std::span<const BuildChild> children) {
  if (children.size() == 1) return children[0];
  BuildNode& node = NewNode();
  const std::size_t share = (children.size() + width - 1) / width;
  for (std::size_t i = 0; i < children.size(); i += share)
    node.Add(Group(children.subspan(i, std::min(share, children.size() - i))));
  return ChildOf(node);
}

}  // namespace ray::wide
