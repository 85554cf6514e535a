#pragma once

#include "grader/ShadingRules.h"
#include "source/accelerate/Accelerator.h"

namespace ray::grade {

/// Tests every primitive, as a student's program does, and chooses among the hits by wrong rules.
class RuledDepth : public Accelerator {
 public:
  RuledDepth(const World& world, const DepthRules& rules) : Accelerator(world), rules_(rules) {}

 private:
  void Nearest(const R3::Ray& ray, NearestHit& nearest, Workspace& workspace) const override;
  bool Any(const R3::Ray& ray, Workspace& workspace) const override;

  DepthRules rules_;
};

}  // namespace ray::grade
