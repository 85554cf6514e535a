// Where rays start and end: on surfaces, off surfaces, exactly at a hit.

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"
#include "tests/BoundedShapes.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

/// A world of one shape under one matrix, brute force.
struct Single {
  Single(std::shared_ptr<const R3::Shape> shape, const R3::Matrix& matrix) {
    ray::Node group, leaf;
    leaf.shape = std::move(shape);
    SetBounds(leaf);
    group.transform = matrix;
    group.children.push_back(std::move(leaf));
    SetBounds(group);
    scene.root.children.push_back(std::move(group));
    SetBounds(scene.root);
    world = std::make_unique<ray::World>(scene);
    accelerator = ray::FindAcceleratorKind("none")->Make(*world, {});
  }

  std::optional<ray::WorldHit> Hit(const R3::Ray& ray) { return accelerator->Intersect(ray, workspace); }

  ray::Scene scene;
  std::unique_ptr<ray::World> world;
  std::unique_ptr<const ray::Accelerator> accelerator;
  ray::Workspace workspace;
};

std::vector<std::shared_ptr<const R3::Shape>> ConvexShapes() {
  std::vector<std::shared_ptr<const R3::Shape>> shapes;
  for (const auto* kind : BoundedShapeKinds()) {
    auto shape = kind->make(kind->example);
    if (crossings::IsConvex(*shape)) shapes.push_back(std::move(shape));
  }
  R3::MeshData octahedron;
  octahedron.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  shapes.push_back(std::make_shared<R3::Mesh>(octahedron));
  return shapes;
}

R3::Matrix Uniform(double s) {
  R3::Matrix m;
  m.m = {{{s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}}};
  return m;
}

/// A ray from afar to a random place in the shape's world box.
R3::Ray RayTowards(Draw& draw, const Single& single) {
  const R3::Box& box = single.scene.root.bounds;
  const R3::Vector size = box.Size();
  const R3::Point origin = box.Center() + 3 * box.Radius() * draw.Direction();
  const R3::Point target =
      box.low + R3::Vector{size.x * draw.Between(0, 1), size.y * draw.Between(0, 1), size.z * draw.Between(0, 1)};
  return {origin, target - origin};
}

/// A direction into the half space of n; a fifth of them graze it, with cosines from 1 to 1e-4 drawn by exponent.
R3::Vector Away(Draw& draw, const R3::Vector& n) {
  const R3::Vector d = draw.Direction();
  if (draw.Whole(0, 4) > 0) return Dot(d, n) > 0 ? d : -d;
  const R3::Vector along = Unit(Cross(n, d));
  const double cosine = draw.Scale(-4, 0);
  return Unit(std::sqrt(1 - cosine * cosine) * along + cosine * n);
}

TEST(Extremes, E1_SpawnedRaysNeverHitTheirOwnSurface) {
  Draw draw(601);
  for (const auto& shape : ConvexShapes()) {
    std::vector<R3::Matrix> matrices;
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) matrices.push_back(Uniform(scale));
    for (int i = 0; i < 10; ++i) matrices.push_back(draw.Affine(6));
    for (const R3::Matrix& matrix : matrices) {
      Single single(shape, matrix);
      for (int i = 0; i < Count(40, 600); ++i) {
        const R3::Ray ray = RayTowards(draw, single);
        const auto hit = single.Hit(ray);
        if (!hit) continue;
        const R3::Intersection at = single.world->At(ray, *hit);
        const double side = Dot(at.normal, ray.direction) < 0 ? 1 : -1;
        for (int k = 0; k < Count(100, 1000); ++k) {
          const R3::Vector away = Away(draw, side * AsVector(at.normal));
          const R3::Ray spawned{SpawnPoint(at, away), away};
          const bool must_miss = !shape->IsSolid() || side > 0;
          ASSERT_TRUE(!must_miss || !single.Hit(spawned)) << oracle::Hex(ray) << " then " << oracle::Hex(spawned);
        }
      }
    }
  }
}

TEST(Extremes, E2_AnOccluderJustAboveTheSurfaceIsNeverMissed) {
  Draw draw(602);
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    Single below(R3::MakeShape("box", {-1, -1, -1, 1, 1, 1}), Uniform(scale));
    Single above(R3::MakeShape("box", {-2, 1.00001, -2, 2, 2, 2}), Uniform(scale));
    for (int i = 0; i < Count(5'000, 1'000'000); ++i) {
      const R3::Point origin = R3::Point{} + scale * R3::Vector{draw.Between(-2, 2), 4, draw.Between(-2, 2)};
      const R3::Point target = R3::Point{} + scale * R3::Vector{draw.Between(-1, 1), 1, draw.Between(-1, 1)};
      const R3::Ray ray{origin, target - origin};
      const auto hit = below.Hit(ray);
      if (!hit) continue;
      const R3::Intersection at = below.world->At(ray, *hit);
      if (at.normal.y < 0.5) continue;
      const R3::Vector away = Away(draw, {0, 1, 0});
      if (away.y < 1e-3) continue;  // beyond, the occluder's edge comes first
      EXPECT_TRUE(above.Hit({SpawnPoint(at, away), away})) << oracle::Hex(ray);
    }
  }
}

TEST(Extremes, E3_AShellThinAsPaintIsEnteredAndLeft) {
  // From a hit on the outer sphere, straight on: the inner one, 4e-5 below, must be found whenever the ray meets it.
  Single inner(R3::MakeShape("sphere", {0, 0, 0, 1}), Uniform(1)),
      outer(R3::MakeShape("sphere", {0, 0, 0, 1.00004}), Uniform(1));
  Draw draw(603);
  for (int i = 0; i < 20'000; ++i) {
    const R3::Ray ray = RayTowards(draw, outer);
    const auto hit = outer.Hit(ray);
    if (!hit) continue;
    const R3::Vector d = Unit(ray.direction);
    const auto o = oracle::Of(ray.origin);
    const double impact = oracle::Double(oracle::Length(oracle::Cross(o, oracle::Of(ray.direction))) /
                                         oracle::Length(oracle::Of(ray.direction)));
    if (impact > 1 - 1e-9) continue;
    EXPECT_TRUE(inner.Hit({SpawnPoint(outer.world->At(ray, *hit), d), d})) << oracle::Hex(ray);
  }
}

TEST(Extremes, C4_RaysFromASurfaceHitOnlyItsFarSide) {
  const auto check = [](const char* name, const std::vector<double>& arguments, const R3::Point& p,
                        const R3::Vector& out) {
    const auto shape = R3::MakeShape(name, arguments);
    EXPECT_FALSE(shape->Intersect({p, out}, 0)) << name;
    const auto far_side = shape->Intersect({p, -out}, 0);
    ASSERT_TRUE(far_side) << name;
    EXPECT_GT(far_side->t, 0.1) << name;
    EXPECT_TRUE(std::isfinite(shape->At({p, -out}, *far_side, 0).position.x));
  };
  check("sphere", {0, 0, 0, 1}, {1, 0, 0}, {1, 0, 0});
  check("sphere", {0, 0, 0, 1}, {0, -1, 0}, {0.5, -1, 0.25});
  check("box", {-1, -1, -1, 1, 1, 1}, {1, 0.5, 0.25}, {1, 0, 0});
  check("box", {-1, -1, -1, 1, 1, 1}, {1, 1, 0.25}, {1, 1, 0});  // on an edge
  check("box", {-1, -1, -1, 1, 1, 1}, {1, 1, 1}, {1, 1, 1});     // on a corner
  check("box", {-1, -1, -1, 1, 1, 1}, {-1, 1, -1}, {-1, 2, -3});
  check("cylinder", {0, 0, 0, 1, 2}, {1, 0.5, 0}, {1, 0, 0});
  check("cylinder", {0, 0, 0, 1, 2}, {0.25, 1, 0}, {0, 1, 0});
  check("cylinder", {0, 0, 0, 1, 2}, {1, 1, 0}, {1, 1, 0});  // on the rim
  check("cone", {0, 0, 0, 1, 2}, {0, 1, 0}, {0, 1, 0});      // on the apex
  check("cone", {0, 0, 0, 1, 2}, {0.25, -1, 0}, {0, -1, 0});
  check("cone", {0, 0, 0, 1, 2}, {0.5, 0, 0}, {1, 0.5, 0});  // half way up the side, exactly
}

TEST(Extremes, C4_FromInsideEverySolidIsLeftOnceMoreThanEntered) {
  Draw draw(604);
  for (const auto* kind : BoundedShapeKinds()) {
    const auto shape = kind->make(kind->example);
    if (!shape->IsSolid()) continue;
    const R3::Point inside = crossings::PointInside(*shape);
    const bool is_convex = crossings::IsConvex(*shape);
    for (int i = 0; i < 10'000; ++i) {
      const R3::Ray ray{inside, draw.Direction()};
      const auto hit = shape->Intersect(ray, 0);
      ASSERT_TRUE(hit) << kind->name << ' ' << oracle::Hex(ray);
      EXPECT_GT(Dot(shape->At(ray, *hit, 0).normal, ray.direction), 0);
      const int count = crossings::Count(*shape, ray);
      EXPECT_TRUE(is_convex ? count == 1 : count % 2 == 1) << kind->name << ' ' << count << ' ' << oracle::Hex(ray);
    }
  }
}

TEST(Extremes, C12_TheEndOfARayIsExclusive) {
  Draw draw(605);
  for (const auto& shape : ConvexShapes()) {
    Single single(shape, draw.Affine(1));
    for (int i = 0; i < 2'000; ++i) {
      const R3::Ray ray = RayTowards(draw, single);
      const auto hit = single.Hit(ray);
      if (!hit) continue;
      const double t = hit->t;
      for (const auto& [end, expected] :
           {std::pair{R3::NextDown(t), false}, std::pair{t, false}, std::pair{R3::NextUp(t), true}}) {
        EXPECT_EQ(single.Hit({ray.origin, ray.direction, 0, end}).has_value(), expected);
        // A shadow ray is not blocked by the surface that it ends on, on whichever side of it rounding puts its end.
        EXPECT_FALSE(single.accelerator->IsOccluded({ray.origin, ray.direction, 0, end}, single.workspace));
      }
      if (std::abs(Dot(single.world->At(ray, *hit).normal, Unit(ray.direction))) < 0.01) continue;
      EXPECT_TRUE(single.accelerator->IsOccluded({ray.origin, ray.direction, 0, (1 + 0x1p-20) * t}, single.workspace));
    }
  }
}

}  // namespace
