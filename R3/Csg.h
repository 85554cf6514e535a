#pragma once

#include <optional>
#include <vector>

#include "R3/CsgPart.h"
#include "R3/CsgSolid.h"
#include "R3/CsgTree.h"
#include "R3/Shape.h"

namespace R3 {

/// A solid made of solids (constructive solid geometry).
///
/// Along the line of a ray, the crossings of each solid are found by repeated calls of its Intersect, with the last t
/// as t_min. A hit is where the value of the whole expression changes. Every crossing has an interval that contains its
/// exact t in spite of rounding, and crossings with overlapping intervals are simultaneous: faces that coincide up to
/// rounding leave no film between them, and sheets thinner than rounding vanish. This is the regularized operation of
/// Requicha, Representations for rigid solids (1980), section 3, on the line.
///
/// A crossing at t is off the surface by at most
///     n . (error of the surface + rounding of moving the ray into the solid's frame) + 64 u (|o| + |t| |d|) + slack
/// along its normal n, all in the solid's frame: Intersect guarantees 32 u (D + size), and D + size is less than twice
/// |o| + |t| |d|. Divided by |n . d|, this is half the interval, but no more than the solid's own extent along the ray:
/// crossings of a grazing ray are no less certain than that.
///
/// The value is computed from minus infinity on, so a ray may start anywhere. Crossings of one solid must alternate
/// between in and out; see AddAlternating in CsgCrossings.cpp for the case that rounding at a touch or an edge
/// contradicts this.
class Csg : public Shape {
 public:
  /// Makes a Csg of parts. The first part is the whole; every operation has at least one part. Solids are bounded and
  /// closed.
  explicit Csg(std::vector<CsgPart> parts);
  Csg(const Csg&) = delete;

  Box Bounds(int) const override { return bounds_; }
  std::optional<Hit> Intersect(const Ray& ray, int) const override;
  Intersection At(const Ray& ray, const Hit& hit, int) const override;
  UvTangents UvTangentsAt(const Ray& ray, const Hit& hit, int) const override;
  bool HasTextureCoordinates() const override;
  bool IsDegenerate() const override { return is_empty_; }
  std::vector<int> MaterialsOfParts() const override;
  int MaterialOf(const Hit& hit) const override { return parts_[PartOf(hit)].material; }

 private:
  class Insides;
  /// The result of repeating the Intersect of a solid.
  struct OfSolid {
    const Shape& solid;
    Ray ray;
    Hit hit;
    int element;
  };
  /// The properties of a part that are used while following a ray from crossing to crossing.
  struct Link {
    std::uint32_t parent = 0;
    CsgOperation operation = CsgOperation::unite;
    bool is_first = false;      // whether it is the first part of its parent
    std::int32_t children = 0;  // number of parts whose parent it is
  };

  static std::size_t PartOf(const Hit& hit) { return static_cast<std::size_t>(hit.part); }
  OfSolid Again(const Ray& ray, const Hit& hit) const;
  std::vector<Box> BoxesOfParts() const;

  std::vector<CsgPart> parts_;
  std::vector<Link> links_;            // of the parts
  std::vector<CsgSolid> solids_;       // the solids that can be hit
  std::vector<std::uint32_t> number_;  // the index in solids_ of a part's solid
  std::vector<char> is_inside_out_;    // true if the part is subtracted an odd number of times
  CsgTree tree_;
  Box bounds_;
  bool is_empty_ = false;
};

}  // namespace R3
