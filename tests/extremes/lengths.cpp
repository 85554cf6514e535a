// Lengths far from 1: A9 and A12. A power of two changes exponents alone, so that everything but the exponent of t
// stays to the bit; the oracle is the shape of ordinary size, whose truth other tests look after.

#include <gtest/gtest.h>

#include <cmath>

#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace R3 {
namespace {

constexpr int rounds = 400;

Ray Scaled(const Ray& ray, int of_lengths, int of_direction) {
  const auto scaled = [](double x, double y, double z, int e) {
    return Vector{std::scalbn(x, e), std::scalbn(y, e), std::scalbn(z, e)};
  };
  Ray far = ray;
  far.origin = Point{} + scaled(ray.origin.x, ray.origin.y, ray.origin.z, of_lengths);
  far.direction = scaled(ray.direction.x, ray.direction.y, ray.direction.z, of_direction);
  return far;
}

/// From outside towards somewhere near the shape.
Ray RayAt(const Shape& shape, Draw& draw) {
  const Box box = shape.Bounds(0);
  const Vector size = box.Size();
  const Point aim = box.low + Vector{draw.Between(-0.1, 1.1) * size.x, draw.Between(-0.1, 1.1) * size.y,
                                     draw.Between(-0.1, 1.1) * size.z};
  const Point from = box.Center() + 4 * Length(size) * draw.Direction();
  return {from, aim - from};
}

TEST(Extremes, A9_ShapesOfAnySizeAreHitAlike) {
  for (const ShapeKind* kind : BoundedShapeKinds()) {
    const auto shape = MakeShape(kind->name, kind->example);
    for (const int exponent : {-900, -700, -520, -400, -300, -200, 200, 340, 400, 490}) {
      std::vector<double> numbers = kind->example;
      for (double& number : numbers) number = std::scalbn(number, exponent);
      const auto scaled = MakeShape(kind->name, numbers);
      Draw draw(7);
      int hits = 0;
      for (int i = 0; i < rounds; ++i) {
        const Ray ray = RayAt(*shape, draw);
        const auto usual = shape->Intersect(ray, 0), found = scaled->Intersect(Scaled(ray, exponent, 0), 0);
        ASSERT_EQ(found.has_value(), usual.has_value()) << kind->name << " 2^" << exponent;
        if (!found) continue;
        ++hits;
        ASSERT_EQ(found->t, std::scalbn(usual->t, exponent)) << kind->name << " 2^" << exponent;
        const Normal n = shape->At(ray, *usual, 0).normal, m = scaled->At(Scaled(ray, exponent, 0), *found, 0).normal;
        ASSERT_LE(Length(AsVector(n) - AsVector(m)), 1e-12) << kind->name << " 2^" << exponent;
      }
      EXPECT_GT(hits, rounds / 8) << kind->name << " 2^" << exponent;
    }
  }
}

TEST(Extremes, A12_ADirectionOfAnyLengthFindsTheSameHit) {
  for (const ShapeKind* kind : BoundedShapeKinds()) {
    const auto shape = MakeShape(kind->name, kind->example);
    for (const int exponent : {-498, -400, -300, -100, 100, 300, 400, 498}) {  // 1e-150 to 1e150
      Draw draw(8);
      int hits = 0;
      for (int i = 0; i < rounds; ++i) {
        const Ray ray = RayAt(*shape, draw);
        const auto usual = shape->Intersect(ray, 0), found = shape->Intersect(Scaled(ray, 0, exponent), 0);
        ASSERT_EQ(found.has_value(), usual.has_value()) << kind->name << " 2^" << exponent;
        if (!found) continue;
        ++hits;
        const double t = std::scalbn(usual->t, -exponent);
        ASSERT_LE(std::abs(found->t - t), 8 * unit_roundoff * t) << kind->name << " 2^" << exponent;
      }
      EXPECT_GT(hits, rounds / 8) << kind->name << " 2^" << exponent;
    }
  }
}

}  // namespace
}  // namespace R3

namespace {

// From outside: a scene of one length, its numbers alone larger or smaller.
TEST(Extremes, A9_ASceneOfAnySizeGivesTheSameImage) {
  const auto render = [](int exponent, const char* accelerator) {
    const std::string e = "e" + std::to_string(exponent) + " ", o = "0 ";
    const project::Stage stage(project::FromText(
        "camera 0 0 5" + e + " 0 0 -1 0 1 0 .4 .1" + e + "9" + e + "\ndir_light 1 1 1 -1 -1 -3\nsphere -1 -1" + e + o +
        o + ".7" + e + "\ncylinder -1 1" + e + o + o + ".5" + e + "1" + e + "\ncone -1 0 1" + e + o + ".5" + e + "1" +
        e + "\ntri -1 -1" + e + "-1" + e + o + "1" + e + "-1" + e + o + o + "-.5" + e + "1" + e + "\n"));
    return project::Render(stage, project::Sized(48), {.name = accelerator}).image;
  };
  // Decimal scales round the numbers themselves: pixels at outlines may change sides, no others.
  const R2::Image usual = render(0, "none");
  for (const char* accelerator : {"none", "bvh", "grid", "octree"})
    for (const int exponent : {-250, -160, -155, -120, -80, 80, 90, 120, 149}) {
      const R2::Image image = render(exponent, accelerator);
      int different = 0;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) different += std::abs(image.At(x, y).g - usual.At(x, y).g) > 1e-5;
      EXPECT_LE(different, 4) << accelerator << " 1e" << exponent;
    }
}

}  // namespace
