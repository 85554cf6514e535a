#include <gtest/gtest.h>

#include "tests/Project.h"

namespace {

// A triangle in the plane z = 0 had no error along z, so shadow rays left it from z = 0 exactly. Towards a light for
// which x is the main axis, the triangle's own t then came out as plus or minus a rounding error instead of 0, and
// every other pixel shadowed itself. The error now also holds a share of the distance to the farthest corner.
TEST(Regression, ATriangleInACoordinatePlaneDoesNotSpeckleItself) {
  const char* const triangles[] = {"tri -1 -2 -2 0 2 -2 0 0 2 0", "tri -1 0 -2 -2 0 2 -2 0 0 2",
                                   "tri -1 -2 0 -2 0 0 2 2 0 -2"};
  for (const char* triangle : triangles) {
    const project::Stage stage(project::FromText(std::string("camera 3 4 5 -3 -4 -5 0 1 0 0.1 0.01 100 ambient 0 0 0 "
                                                             "dir_light 1 1 1 -3 -1 -1 dir_light 1 1 1 -1 -3 -1 "
                                                             "dir_light 1 1 1 -1 -1 -3 ") +
                                                 triangle));
    ray::RenderSettings with_shadows, without;
    with_shadows.width = with_shadows.height = without.width = without.height = 64;
    without.trace.shadows = false;
    const auto lit = project::Render(stage, with_shadows);
    EXPECT_TRUE(lit.image == project::Render(stage, without).image) << triangle;
    EXPECT_GT(lit.rays[ray::RayKind::shadow].rays, 1000u);
  }
}

}  // namespace
