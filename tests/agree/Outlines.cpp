// Rays along the outlines of shapes, as close to just hitting or just missing as doubles allow: for any tests before a
// shape's own, all accelerators find the hits of the latter.

#include <gtest/gtest.h>

#include "R3/ShapeKind.h"
#include "tests/Accelerators.h"

namespace {

using accelerators::Compare;
using accelerators::EveryWay;
using accelerators::Group;
using accelerators::Leaf;

/// Returns rays from `eye` that just hit a shape of `world`, between a direction that does and one that does not: the
/// last two of a bisection, and some next to them.
void AddOutline(const ray::World& world, const ray::Accelerator& accelerator, const R3::Point& eye, Draw& draw,
                std::vector<R3::Ray>& rays) {
  ray::Workspace workspace;
  const auto meets = [&](const R3::Vector& direction) {
    return accelerator.Intersect({eye, direction}, workspace).has_value();
  };
  const R3::Box box = world.scene().root.bounds;
  const R3::Vector reach = box.Size() / 2;
  const auto towards = [&](double far) {
    const R3::Vector v = far * draw.Direction();
    return box.Center() + R3::Vector{v.x * reach.x, v.y * reach.y, v.z * reach.z} - eye;
  };
  R3::Vector hit = towards(0.3), miss = towards(3);
  for (int tries = 0; tries < 20 && !meets(hit); ++tries) hit = towards(0.6);
  if (!meets(hit) || meets(miss)) return;
  for (int halves = 0; halves < 60; ++halves) {
    const R3::Vector middle = 0.5 * (hit + miss);
    (meets(middle) ? hit : miss) = middle;
  }
  const double length = draw.Scale(-3, 3);
  for (const R3::Vector& direction : {hit, miss, hit + draw.Scale(-16, -6) * (miss - towards(1))})
    rays.push_back({eye, length * direction});
  if (const auto met = accelerator.Intersect({eye, hit}, workspace)) {
    const double ulps = draw.Whole(-2, 2) * 0x1p-52;
    rays.push_back({eye, hit, 0, (1 + ulps) * met->t});
    rays.push_back({R3::Ray{eye, hit}.At(met->t * draw.Between(0.5, 1)), length * hit});
  }
}

/// Returns a matrix that flattens or stretches one axis by up to that many orders of magnitude, then rotates.
R3::Matrix Squeezed(Draw& draw, double powers) {
  R3::Matrix m = draw.Affine(1);
  const auto axis = static_cast<std::size_t>(draw.Whole(0, 2));
  const double by = draw.Scale(-powers, powers / 3);
  for (auto& row : m.m) row[axis] *= by;
  return m;
}

TEST(Outlines, OfTransformedShapesAgreeForEveryAccelerator) {
  const auto ways = EveryWay();
  const auto kinds = BoundedShapeKinds();
  for (int seed = 0; seed < Count(12, 4000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 2100);
    const double powers = draw.Whole(0, 1) ? 0 : draw.Between(0, 9), far = draw.Whole(0, 2) ? 0 : draw.Scale(0, 7);
    ray::Scene scene;
    std::vector<R3::Ray> rays;
    for (int i = 0; i < 12; ++i) {
      const auto* kind = kinds[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(kinds.size()) - 1))];
      ray::Node group = Group(draw.Whole(0, 4) ? Squeezed(draw, powers) : R3::Matrix{});
      for (auto& row : group.transform.m) row[3] += far;
      if (draw.Whole(0, 9) == 0) group.motion = 0.1 * draw.Direction();
      group.children.push_back(Leaf(kind->make(kind->example)));
      SetBounds(group);
      // The shape is alone, so that outlines are found which others would hide.
      ray::Scene alone;
      alone.root.children.push_back(std::move(group));
      SetBounds(alone.root);
      {
        const ray::World world(alone);
        const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
        const R3::Box box = alone.root.bounds;
        for (int k = 0; k < 6; ++k)
          AddOutline(world, *none, box.Center() + draw.Scale(-1, 2) * box.Radius() * draw.Direction(), draw, rays);
      }
      scene.root.children.push_back(std::move(alone.root.children[0]));
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    SCOPED_TRACE("seed " + std::to_string(seed + 2100));
    EXPECT_FALSE(rays.empty());
    Compare(world, rays, ways);
  }
}

TEST(Outlines, OfManyRotatedShapesAreTheSameInPackets) {
  const auto ways = EveryWay();
  const auto kinds = BoundedShapeKinds();
  for (int seed = 0; seed < Count(8, 1000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 2200);
    ray::Scene scene;
    for (int i = 0; i < 60; ++i) {
      const auto* kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
      ray::Node group = Group(draw.Affine(0.5));
      group.children.push_back(Leaf(kind->make(kind->example)));
      SetBounds(group);
      scene.root.children.push_back(std::move(group));
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
    std::vector<R3::Ray> some, rays;
    for (int i = 0; i < 60; ++i)
      AddOutline(world, *none, R3::Point{} + draw.Scale(-0.5, 1.5) * draw.Direction(), draw, some);
    for (const R3::Ray& ray : some)
      for (const R3::Ray& one : accelerators::Bundle(draw, ray, 16, 0, draw.Scale(-16, -2))) rays.push_back(one);
    SCOPED_TRACE("seed " + std::to_string(seed + 2200));
    EXPECT_FALSE(rays.empty());
    Compare(world, rays, ways);
  }
}

}  // namespace
