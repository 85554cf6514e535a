#pragma once

#include "R3/Box.h"
#include "source/accelerate/World.h"

namespace ray {

/// A box around all emissive shapes, for rays that can only bring emission.
class EmissionBounds {
 public:
  explicit EmissionBounds(const World& world);

  /// Returns false only for a ray that hits no emissive shape, regardless of how tests of shapes are rounded.
  bool MayBeHitBy(const R3::Ray& ray) const;

 private:
  R3::Box box_;
  double padding_per_distance_ = 0;  // of the ray's origin from the world's, in its largest component
  bool is_unbounded_ = false;
};

}  // namespace ray
