#include "source/accelerate/wide/Parts.h"

#include <algorithm>

namespace ray::bvh {
namespace {

Float4 Floats(const R3::Vector& v) {
  return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}

/// The box of what is left of a triangle inside the cell; false when nothing is.
bool BoxWithin(const R3::Box& cell, const std::array<R3::Vector, 3>& corners, Extent& box) {
  std::array<R3::Vector, 9> polygon{corners[0], corners[1], corners[2]}, cut;
  std::size_t count = 3;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const R3::Vector end = FromOrigin(side < 0 ? cell.low : cell.high);
      const auto inside = [&](const R3::Vector& p) { return side * (end[axis] - p[axis]); };  // by how much
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

Part WholePart(const Tree& tree, std::uint32_t item) {
  const R3::Box bounds = tree.space.Bounds(item);
  return {{Floats(tree.coordinates(bounds.low)), Floats(tree.coordinates(bounds.high))},
          item,
          tree.space.MeshOf(item) != nullptr};
}

bool CutTo(const R3::Box& cell, const Tree& tree, Part& part) {
  Extent box{Floats(FromOrigin(cell.low)), Floats(FromOrigin(cell.high))};
  if (part.is_triangle) {
    const auto corners = tree.space.MeshOf(part.item)->Corners(tree.space[part.item].element);
    const std::array placed{tree.coordinates(corners[0]), tree.coordinates(corners[1]), tree.coordinates(corners[2])};
    if (!BoxWithin(cell, placed, box)) return false;
  }
  part.box.low = Most(part.box.low, box.low - box_rounding);
  part.box.high = Least(part.box.high, box.high + box_rounding);
  for (int axis = 0; axis < 3; ++axis)
    if (part.box.low[axis] > part.box.high[axis]) return false;
  return true;
}

BuildChild Grouping::operator()(std::span<Part> parts) {
  if (parts.empty()) return {};
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
  std::vector<BuildChild> slots;
  for (const Part& part : parts) {
    const bool is_next = part.is_triangle && !slots.empty() && slots.back().triangles < width;
    BuildChild& slot = is_next ? slots.back() : slots.emplace_back();
    slot.box.Extend(part.box);
    slot.items[static_cast<std::size_t>(slot.triangles)] = part.item;
    if (part.is_triangle) ++slot.triangles;
  }
  return Group(slots);
}

BuildChild Grouping::Group(std::span<const BuildChild> slots) {
  if (slots.size() == 1) return slots[0];
  BuildNode& draft = NewDraft();
  const std::size_t share = (slots.size() + width - 1) / width;
  for (std::size_t i = 0; i < slots.size(); i += share)
    draft.Add(Group(slots.subspan(i, std::min(share, slots.size() - i))));
  return BuildChildOf(draft);
}

}  // namespace ray::bvh
