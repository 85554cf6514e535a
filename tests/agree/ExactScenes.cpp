// Whole scenes against arithmetic of 113 bits that tries every shape: what transforms, structures and shapes make of a
// ray together. If this fails, things are missing from pictures, or are where they should not be.

#include <gtest/gtest.h>

#include "tests/Accelerators.h"
#include "tests/ExactScene.h"

namespace {

TEST(ExactScenes, RaysHitWhatTheyShouldInRandomScenesOfEveryShape) {
  for (const double powers : {0.0, 1.0, 2.0})
    for (int seed = 0; seed < Count(10, 1000); ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 1300);
      const ray::Scene scene = accelerators::RandomScene(draw, powers, AllShapeKinds());
      const ray::World world(scene);
      const oracle::Scene exact(world);
      const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
      ray::Workspace workspace;
      for (const R3::Ray& ray : accelerators::RaysAt(world, draw, 20))
        EXPECT_EQ(exact.WhatIsWrong(ray, none->Intersect(ray, workspace)), "")
            << "seed " << seed + 1300 << " powers " << powers << ' ' << oracle::Hex(ray);
    }
}

}  // namespace
