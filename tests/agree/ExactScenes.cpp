// Whole scenes compared with arithmetic of 113 bits that tests every shape: the combined effect of transforms,
// structures and shapes on a ray. If this fails, objects are missing from images or misplaced.

#include <gtest/gtest.h>

#include "tests/Accelerators.h"
#include "tests/ExactScene.h"

namespace {

TEST(ExactScenes, RandomScenesHaveTheHitsOfExactArithmetic) {
  for (const double powers : {0.0, 1.0, 2.0})
    for (int seed = 0; seed < Count(10, 1000); ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 1300);
      const ray::Scene scene = accelerators::RandomScene(draw, powers, JudgedShapeKinds());
      const ray::World world(scene);
      const oracle::Scene exact(world);
      const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
      ray::Workspace workspace;
      for (const R3::Ray& ray : accelerators::RaysAt(world, draw, 20))
        EXPECT_EQ(exact.WhatIsWrong(ray, none->Intersect(ray, workspace)), "")
            << "seed " << seed + 1300 << " powers " << powers << ' ' << oracle::Hex(ray);
    }
}

// Some random rays have no direction. The judge once read the last element of an empty list of breaks.
TEST(ExactScenes, ALineWithoutDirectionCrossesNoRing) {
  const oracle::Ring ring{1, 0.4};
  EXPECT_TRUE(ring.Breaks({{1, 2, 3}, {0, 0, 0}}, 0).empty());
  EXPECT_FALSE(ring.Breaks({{1, 2, 3}, {0, 0, 1}}, 0).empty());
}

// Faults that the judge cannot see would go unreported.
TEST(ExactScenes, AnswersWithAPlantedFaultAreFound) {
  int answers = 0, found_missing = 0, found_off = 0, found_late = 0;
  for (int seed = 0; seed < 30; ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 1400);
    const ray::Scene scene = accelerators::RandomScene(draw, 1, JudgedShapeKinds());
    const ray::World world(scene);
    const oracle::Scene exact(world);
    const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
    ray::Workspace workspace;
    for (R3::Ray ray : accelerators::RaysAt(world, draw, 20)) {
      const auto hit = none->Intersect(ray, workspace);
      if (!hit || hit->t < 1e-3) continue;  // rays that start on a surface may be on either side of it
      ++answers;
      found_missing += !exact.WhatIsWrong(ray, {}).empty();
      auto off = hit;
      off->t *= 1 + 1e-6;
      found_off += !exact.WhatIsWrong(ray, off).empty();
      R3::Ray rest = ray;
      rest.t_min = hit->t;
      found_late += !exact.WhatIsWrong(ray, none->Intersect(rest, workspace)).empty();
    }
  }
  EXPECT_GT(answers, 150);
  // The others graze their surface, or are within the errors of distant rays.
  EXPECT_GT(found_missing, 0.95 * answers);
  EXPECT_GT(found_off, 0.95 * answers);
  EXPECT_GT(found_late, 0.95 * answers);
}

}  // namespace
