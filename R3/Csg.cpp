#include "R3/Csg.h"

#include <algorithm>
#include <cassert>

#include "R3/CsgCrossings.h"

namespace R3 {

/// The parts of a Csg that contain the current point, as a line proceeds from crossing to crossing.
class Csg::Insides {
 public:
  explicit Insides(const std::vector<Link>& links) : links_(links) { states_.assign(links.size(), {}); }

  bool OfAll() const { return states_[0].is_inside; }

  /// Enters or leaves a solid, and updates the parts above it. Simultaneous crossings share one `group`, a number above
  /// 0.
  void Cross(std::uint32_t part, bool enters, std::uint32_t group) {
    for (;;) {
      State& state = states_[part];
      if (state.is_inside == enters) return;
      if (state.group != group) state.group = group, state.was_inside = state.is_inside;
      state.is_inside = enters;
      if (part == 0) return;
      const Link& link = links_[part];
      State& parent = states_[link.parent];
      parent.inside += enters ? 1 : -1;
      if (link.is_first) parent.is_inside_first = enters;
      part = link.parent;
      enters = Value(part);
    }
  }

  /// Returns true if the group of crossings changed the part and all parts above it.
  bool HaveChangedUpFrom(std::uint32_t part, std::uint32_t group) const {
    for (;; part = links_[part].parent) {
      const State& state = states_[part];
      if (state.group != group || state.was_inside == state.is_inside) return false;
      if (part == 0) return true;
    }
  }

 private:
  struct State {
    std::uint32_t group = 0;       // the last group of crossings that changed it
    std::int32_t inside = 0;       // number of its parts that contain the point
    bool is_inside_first = false;  // whether the first of them does
    bool is_inside = false;
    bool was_inside = false;  // before the group
  };

  bool Value(std::uint32_t part) const {
    const State& state = states_[part];
    switch (links_[part].operation) {
      case CsgOperation::unite:
        return state.inside > 0;
      case CsgOperation::intersect:
        return state.inside == links_[part].children;
      case CsgOperation::subtract:
        return state.inside == 1 && state.is_inside_first;
    }
    return false;
  }

  const std::vector<Link>& links_;
  R1::StackVector<State, 48> states_;
};

namespace {

/// Sorts crossings along the line of the ray by the start of their intervals, then by part.
void Sort(CsgCrossings& crossings) {
  const auto is_before = [](const CsgCrossing& a, const CsgCrossing& b) {
    return a.low != b.low ? a.low < b.low : a.part < b.part;
  };
  constexpr std::size_t few = 16;
  if (crossings.size() > few) return std::sort(crossings.begin(), crossings.end(), is_before);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const CsgCrossing next = crossings[i];
    std::size_t k = i;
    for (; k > 0 && is_before(next, crossings[k - 1]); --k) crossings[k] = crossings[k - 1];
    crossings[k] = next;
  }
}

/// Returns the end of the crossings, starting at `first`, that are simultaneous.
std::size_t EndOfGroup(const CsgCrossings& crossings, std::size_t first) {
  double high = crossings[first].high;
  std::size_t last = first + 1;
  for (; last < crossings.size() && crossings[last].low <= high; ++last) high = std::max(high, crossings[last].high);
  return last;
}

bool IsLine(const Ray& ray) {
  return IsFinite(FromOrigin(ray.origin)) && IsFinite(ray.direction) && MaxComponent(Abs(ray.direction)) > 0;
}

}  // namespace

Csg::Csg(std::vector<CsgPart> parts)
    : parts_(std::move(parts)), links_(parts_.size()), number_(parts_.size()), is_inside_out_(parts_.size(), 0) {
  CsgSolid::Pad pad;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const CsgPart& part = parts_[i];
    assert(!part.solid || (part.solid->IsBounded() && part.solid->Elements() >= 0));
    if (part.solid && !part.solid->IsDegenerate()) {
      number_[i] = static_cast<std::uint32_t>(solids_.size());
      const CsgSolid& solid = solids_.emplace_back(part, static_cast<std::uint32_t>(i));
      const CsgSolid::Pad of_solid = solid.PadOfCrossings();
      pad = {std::max(pad.base, of_solid.base), std::max(pad.share, of_solid.share)};
    }
    links_[i].operation = part.operation;
    if (i == 0) continue;
    const auto parent = static_cast<std::size_t>(part.parent);
    assert(parent < i);
    links_[i].parent = static_cast<std::uint32_t>(parent);
    links_[i].is_first = links_[parent].children++ == 0;
    const bool is_subtracted = parts_[parent].operation == CsgOperation::subtract && !links_[i].is_first;
    is_inside_out_[i] = is_inside_out_[parent] != (is_subtracted ? 1 : 0);
  }
  std::vector<Box> boxes = BoxesOfParts();
  is_empty_ = boxes[0].IsEmpty();
  bounds_ = is_empty_ ? Box{{0, 0, 0}, {0, 0, 0}} : boxes[0];
  tree_ = CsgTree(parts_, std::move(boxes), pad.base, pad.share);
}

/// Computes the tight box of each part by its operation, from the last part to the whole. Subtracted parts do not
/// shrink a box.
std::vector<Box> Csg::BoxesOfParts() const {
  std::vector<Box> boxes(parts_.size());
  std::vector<char> has_box(parts_.size(), 0);
  for (const CsgSolid& solid : solids_) boxes[solid.number] = solid.bounds;
  for (std::size_t i = parts_.size(); i-- > 1;) {
    Box& of_parent = boxes[links_[i].parent];
    const CsgOperation operation = links_[links_[i].parent].operation;
    if (operation == CsgOperation::subtract && !links_[i].is_first) continue;
    if (operation == CsgOperation::intersect && has_box[links_[i].parent])
      of_parent = Common(of_parent, boxes[i]);
    else
      of_parent.Extend(boxes[i]);
    has_box[links_[i].parent] = 1;
  }
  return boxes;
}

std::optional<Hit> Csg::Intersect(const Ray& ray, int) const {
  if (is_empty_ || !IsLine(ray)) return {};
  CsgCrossings crossings;
  tree_.ForEachSolid(ray, crossings, [&](std::uint32_t part) { AddCrossings(solids_[number_[part]], ray, crossings); });
  if (crossings.empty()) return {};
  Sort(crossings);
  Insides insides(links_);
  for (std::size_t first = 0, last = 0; first < crossings.size(); first = last) {
    last = EndOfGroup(crossings, first);
    const auto group = static_cast<std::uint32_t>(last);
    const bool before = insides.OfAll();
    for (std::size_t i = first; i < last; ++i) insides.Cross(crossings[i].part, crossings[i].enters, group);
    if (insides.OfAll() == before) continue;
    // Of the parts that cause the change, the first is visible, as for all coincident surfaces.
    const CsgCrossing* seen = nullptr;
    for (std::size_t i = first; i < last; ++i)
      if ((!seen || crossings[i].part < seen->part) && insides.HaveChangedUpFrom(crossings[i].part, group))
        seen = &crossings[i];
    assert(seen);
    if (!(seen->t > ray.t_min)) continue;
    if (!(seen->t < ray.t_max)) return {};
    return Hit{.t = seen->t, .u = static_cast<double>(seen->element), .part = static_cast<int>(seen->part)};
  }
  return {};
}

// A Hit of the Csg has no room for the solid's own Hit, only for the number of the solid. A second query finds exactly
// the same crossing, since the range of t changes none.
Csg::OfSolid Csg::Again(const Ray& ray, const Hit& hit) const {
  const CsgPart& part = parts_[PartOf(hit)];
  OfSolid again{*part.solid, part.csg_from_solid.Back(ray), {}, static_cast<int>(hit.u)};
  again.ray.t_min = NextDown(hit.t), again.ray.t_max = NextUp(hit.t);
  const auto found = again.solid.Intersect(again.ray, again.element);
  assert(found && found->t == hit.t);
  if (found) again.hit = *found;
  return again;
}

Intersection Csg::At(const Ray& ray, const Hit& hit, int) const {
  const OfSolid found = Again(ray, hit);
  const CsgPart& part = parts_[PartOf(hit)];
  Intersection at = found.solid.At(found.ray, found.hit, found.element);
  if (!part.csg_from_solid.IsIdentity()) at = part.csg_from_solid * at;
  if (is_inside_out_[PartOf(hit)]) at.normal = -at.normal, at.shading_normal = -at.shading_normal;
  return at;
}

UvTangents Csg::UvTangentsAt(const Ray& ray, const Hit& hit, int) const {
  const OfSolid found = Again(ray, hit);
  const CsgPart& part = parts_[PartOf(hit)];
  UvTangents uv = found.solid.UvTangentsAt(found.ray, found.hit, found.element);
  uv.first = part.csg_from_solid * uv.first, uv.second = part.csg_from_solid * uv.second;
  return uv;
}

bool Csg::HasTextureCoordinates() const {
  return std::ranges::all_of(parts_, [](const CsgPart& p) { return !p.solid || p.solid->HasTextureCoordinates(); });
}

std::vector<int> Csg::MaterialsOfParts() const {
  std::vector<int> materials;
  for (const CsgPart& part : parts_)
    if (part.material != CsgPart::no_material) materials.push_back(part.material);
  std::ranges::sort(materials);
  materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
  return materials;
}

}  // namespace R3
