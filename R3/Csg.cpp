#include "R3/Csg.h"

#include <algorithm>
#include <cassert>

#include "R3/CsgCrossings.h"

namespace R3 {
namespace {

/// Which parts of a Csg a place is inside of, as a line goes from crossing to crossing.
class Insides {
 public:
  explicit Insides(const std::vector<CsgPart>& parts) : parts_(parts), states_(parts.size()) {
    for (std::size_t i = 1; i < parts.size(); ++i) {
      State& parent = states_[ParentOf(i)];
      states_[i].is_first = parent.children++ == 0;
    }
  }

  bool OfAll() const { return states_[0].is_inside; }

  /// Goes into a solid or out of it, which may change what it is a part of. Crossings that happen at once have one
  /// `group`, a number above 0.
  void Cross(std::size_t part, bool enters, std::size_t group) {
    for (;;) {
      State& state = states_[part];
      if (state.is_inside == enters) return;
      if (state.group != group) state.group = group, state.was_inside = state.is_inside;
      state.is_inside = enters;
      if (part == 0) return;
      const bool is_first = state.is_first;
      part = ParentOf(part);
      State& parent = states_[part];
      const int change = enters ? 1 : -1;
      parent.inside += change;
      if (is_first) parent.inside_first += change;
      enters = Value(part);
    }
  }

  /// Whether the group of crossings changed the part, and all that it is a part of.
  bool HaveChangedUpFrom(std::size_t part, std::size_t group) const {
    for (;; part = ParentOf(part)) {
      const State& state = states_[part];
      if (state.group != group || state.was_inside == state.is_inside) return false;
      if (part == 0) return true;
    }
  }

 private:
  struct State {
    bool is_inside = false;
    bool was_inside = false;           // before the last group of crossings that changed it ...
    std::size_t group = 0;             // ... which is this one
    int children = 0;                  // how many parts name this one their parent,
    int inside = 0, inside_first = 0;  // how many of them the place is inside of, and whether of the first
    bool is_first = false;             // of its parent's parts
  };

  std::size_t ParentOf(std::size_t part) const { return static_cast<std::size_t>(parts_[part].parent); }

  bool Value(std::size_t part) const {
    const State& state = states_[part];
    switch (parts_[part].operation) {
      case CsgOperation::unite:
        return state.inside > 0;
      case CsgOperation::intersect:
        return state.inside == state.children;
      case CsgOperation::subtract:
        return state.inside == 1 && state.inside_first == 1;
    }
    return false;
  }

  const std::vector<CsgPart>& parts_;
  std::vector<State> states_;
};

/// Along the line of the ray, by where their intervals begin; then the first part first.
std::vector<CsgCrossing> CrossingsOf(const std::vector<CsgPart>& parts,
                                     const std::vector<std::optional<ElementTree>>& elements, const Ray& ray) {
  std::vector<CsgCrossing> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!elements[i]) continue;
    for (CsgCrossing& crossing : CrossingsOfSolid(parts[i], *elements[i], ray)) {
      crossing.part = i;
      all.push_back(crossing);
    }
  }
  std::ranges::stable_sort(all, {}, &CsgCrossing::low);
  return all;
}

/// The end of the crossings from `first` on that happen at once.
std::size_t EndOfGroup(const std::vector<CsgCrossing>& crossings, std::size_t first) {
  double high = crossings[first].high;
  std::size_t last = first + 1;
  for (; last < crossings.size() && crossings[last].low <= high; ++last) high = std::max(high, crossings[last].high);
  return last;
}

Box Common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

/// The solid's box in the csg's frame, wherever rounding may have moved it.
Box BoundsOf(const CsgPart& part, const ElementTree& elements) {
  if (elements.Bounds().IsEmpty()) return {};
  const Box box = part.csg_from_solid * elements.Bounds();
  const Vector slack{part.slack, part.slack, part.slack};
  return {box.low - slack, box.high + slack};
}

}  // namespace

Csg::Csg(std::vector<CsgPart> parts)
    : parts_(std::move(parts)), elements_(parts_.size()), is_inside_out_(parts_.size(), 0) {
  std::vector<char> has_children(parts_.size(), 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].solid && !parts_[i].solid->IsDegenerate()) elements_[i].emplace(*parts_[i].solid);
    assert(!parts_[i].solid || (parts_[i].solid->IsBounded() && parts_[i].solid->Elements() >= 0));
    if (i == 0) continue;
    const auto parent = static_cast<std::size_t>(parts_[i].parent);
    assert(parent < i);
    const bool is_subtracted = parts_[parent].operation == CsgOperation::subtract && has_children[parent];
    is_inside_out_[i] = is_inside_out_[parent] != (is_subtracted ? 1 : 0);
    has_children[parent] = 1;
  }
  FindBounds();
}

/// Tight by operation, from the last part to the whole: what is subtracted takes nothing from the box.
void Csg::FindBounds() {
  std::vector<Box> boxes(parts_.size());
  std::vector<char> has_box(parts_.size(), 0);
  std::vector<std::size_t> first_child(parts_.size(), 0);
  for (std::size_t i = parts_.size(); i-- > 1;) first_child[static_cast<std::size_t>(parts_[i].parent)] = i;
  for (std::size_t i = parts_.size(); i-- > 0;) {
    if (elements_[i]) boxes[i] = BoundsOf(parts_[i], *elements_[i]);
    if (i == 0) break;
    const auto parent = static_cast<std::size_t>(parts_[i].parent);
    Box& of_parent = boxes[parent];
    const CsgOperation operation = parts_[parent].operation;
    if (operation == CsgOperation::subtract && first_child[parent] != i) continue;
    if (operation == CsgOperation::intersect && has_box[parent])
      of_parent = Common(of_parent, boxes[i]);
    else
      of_parent.Extend(boxes[i]);
    has_box[parent] = 1;
  }
  is_empty_ = boxes[0].IsEmpty();
  bounds_ = is_empty_ ? Box{{0, 0, 0}, {0, 0, 0}} : boxes[0];
}

std::optional<Hit> Csg::Intersect(const Ray& ray, int) const {
  if (is_empty_) return {};
  const std::vector<CsgCrossing> crossings = CrossingsOf(parts_, elements_, ray);
  Insides insides(parts_);
  for (std::size_t first = 0, last = 0; first < crossings.size(); first = last) {
    last = EndOfGroup(crossings, first);
    const bool before = insides.OfAll();
    for (std::size_t i = first; i < last; ++i) insides.Cross(crossings[i].part, crossings[i].enters, last);
    if (insides.OfAll() == before) continue;
    // Among those that bring about the change, the first part is seen, as with all that coincides.
    const CsgCrossing* seen = nullptr;
    for (std::size_t i = first; i < last; ++i)
      if ((!seen || crossings[i].part < seen->part) && insides.HaveChangedUpFrom(crossings[i].part, last))
        seen = &crossings[i];
    assert(seen);
    if (!(seen->t > ray.t_min)) continue;
    if (!(seen->t < ray.t_max)) return {};
    return Hit{.t = seen->t, .u = static_cast<double>(seen->element), .part = static_cast<int>(seen->part)};
  }
  return {};
}

// A Hit has no room for that of a solid besides which solid it is. Asking again finds the very same, since the range of
// t changes no crossing.
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
