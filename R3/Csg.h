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
  /// What an Intersect of a solid found again.
  struct OfSolid {
    const Shape& solid;
    Ray ray;
    Hit hit;
    int element;
  };
  /// The properties of a part that are used while a ray is followed from crossing to crossing.
  struct Link {
    std::uint32_t parent = 0;
    CsgOperation operation = CsgOperation::unite;
    bool is_first = false;      // of its parent's parts
    std::int32_t children = 0;  // how many parts name this one their parent
  };

  static std::size_t PartOf(const Hit& hit) { return static_cast<std::size_t>(hit.part); }
  OfSolid Again(const Ray& ray, const Hit& hit) const;
  std::vector<Box> BoxesOfParts() const;

  std::vector<CsgPart> parts_;
  std::vector<Link> links_;            // of the parts
  std::vector<CsgSolid> solids_;       // those that can be hit
  std::vector<std::uint32_t> number_;  // of a part's solid in solids_
  std::vector<char> is_inside_out_;    // whether the part is subtracted an odd number of times
  CsgTree tree_;
  Box bounds_;
  bool is_empty_ = false;
};

}  // namespace R3
