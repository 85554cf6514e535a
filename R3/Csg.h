#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "R3/CsgOperation.h"
#include "R3/ElementTree.h"
#include "R3/Shape.h"
#include "R3/Transform.h"

namespace R3 {

/// A solid of a Csg, or an operation on the parts that name it their parent.
struct CsgPart {
  static constexpr int no_parent = -1, no_material = -1;

  int parent = no_parent;  // an earlier part
  CsgOperation operation = CsgOperation::unite;
  std::shared_ptr<const Shape> solid{};  // null for an operation
  Transform csg_from_solid{};
  double slack = 0;  // by how much rounding of the frame's matrices may move the solid, in the csg's own units
  int material = no_material;  // of the solid, numbered by the caller; none: that of the whole Csg
};

/// A solid made of solids (constructive solid geometry).
///
/// Along the line of a ray, each solid is entered and left where asking its Intersect again, with the last t as t_min,
/// finds crossings. A hit is where the value of the whole expression changes. Every crossing has an interval that its t
/// is within in spite of rounding, and crossings whose intervals overlap happen at once: faces that coincide but for
/// rounding leave no film between them, and sheets that are thinner than rounding are not there. This is the
/// regularized operation of Requicha, Representations for rigid solids (1980), section 3, on the line.
///
/// A crossing at t is off the surface by at most
///     n . (error of the surface + what moving the ray into the solid's frame rounds) + 64 u (|o| + |t| |d|) + slack
/// along its normal n, all in the solid's frame: 32 u (D + size) is what Intersect promises, and D + size is less than
/// |o| + |t| |d| twice. Over |n . d|, this is half the interval, but no more than the solid's own extent along the ray:
/// the crossings of a ray that grazes are no less certain than that.
///
/// The value is found from minus infinity on, so a ray may begin anywhere. Crossings of one solid must alternate
/// between in and out: see Alternating in Csg.cpp for what happens where rounding at a touch or an edge says otherwise.
class Csg : public Shape {
 public:
  /// The first of the parts is the whole; every operation has a part. Solids are bounded and closed.
  explicit Csg(std::vector<CsgPart> parts);

  Box Bounds(int) const override { return bounds_; }
  std::optional<Hit> Intersect(const Ray& ray, int) const override;
  Intersection At(const Ray& ray, const Hit& hit, int) const override;
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override;
  bool HasTextureCoordinates() const override;
  bool IsDegenerate() const override { return is_empty_; }
  std::vector<int> MaterialsOfParts() const override;
  int MaterialOf(const Hit& hit) const override { return parts_[PartOf(hit)].material; }

 private:
  /// What an Intersect of a solid found again.
  struct OfSolid {
    const Shape& solid;
    Ray ray;
    Hit hit;
    int element;
  };

  static std::size_t PartOf(const Hit& hit) { return static_cast<std::size_t>(hit.part); }
  OfSolid Again(const Ray& ray, const Hit& hit) const;
  void FindBounds();

  std::vector<CsgPart> parts_;
  std::vector<std::optional<ElementTree>> elements_;  // of the parts that are solids
  std::vector<char> is_inside_out_;                   // whether the part is subtracted an odd number of times
  Box bounds_;
  bool is_empty_ = false;
};

}  // namespace R3
