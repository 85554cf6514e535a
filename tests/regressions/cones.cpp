// Cones that were hit where they are not.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Quad.h"

namespace {

// A plate of radius 1 and height 1e-8, seen from 8e4 away: side and base meet at an angle of 1e-8, so the rounding of
// the two planes' heights (1e-11) moved the rim outward by up to 1e-3 at some rays. The rim is now also clipped to the
// cylinder around it.
TEST(Regression, AFlatConeIsNotHitBeyondItsRim) {
  const auto plate = R3::MakeShape("cone", {0, 0, 0, 1, 1e-8});
  const R3::Ray beside{{0x1.2ac085ad50b01p+13, 0x1.2003a7a24494fp+16, -0x1.0e4f974ffb489p+15},
                       {-0x1.5bf8da8663df3p+14, -0x1.4f7c6ac8068c4p+17, 0x1.3adb7a1e99a6dp+16}};
  EXPECT_FALSE(plate->Intersect(beside, 0));
}

// Rays through the apex: both roots fall together there, and the step of Newton's method that polishes a root divided
// rounding by rounding and moved it by 3000 ulp. It is taken now only where it is more than rounding.
TEST(Regression, ConeApexRootsAreNotPolishedByRounding) {
  const auto cone = R3::MakeShape("cone", {0, 0, 0, 1, 0x1.47ae147ae147bp-7});
  const R3::Ray to_apex{{0x1.92fb0cfdf06c5p-1, 0x1.f1d173e2b6dfep-7, -0x1.4e583dd1b69f1p-4},
                        {-0x1.90f94e24d85bbp-1, -0x1.4c50a2ce87ccap-7, 0x1.4cadff5c847fap-4}};
  const auto hit = cone->Intersect(to_apex, 0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.0050048609568455, 8 * 0x1p-52);  // from 113-bit arithmetic
}

}  // namespace
