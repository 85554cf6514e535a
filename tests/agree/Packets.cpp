// Rays traced in packets get the answers that each gets alone, however coherent they are.

#include <gtest/gtest.h>

#include <limits>

#include "tests/Accelerators.h"

namespace {

using accelerators::Bundle;
using accelerators::Compare;
using accelerators::EveryWay;

ray::Scene SceneOf(const R3::MeshData& data) {
  ray::Scene scene;
  scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(data)));
  SetBounds(scene.root);
  return scene;
}

TEST(Packets, AgreeInRandomScenesWhetherTheyGoTheSameWayOrNot) {
  const auto ways = EveryWay();
  for (const double powers : {0.0, 3.0})
    for (int seed = 0; seed < Count(6, 1000); ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 970);
      const ray::Scene scene = accelerators::RandomScene(draw, powers, AllShapeKinds());
      const ray::World world(scene);
      std::vector<R3::Ray> rays;
      for (R3::Ray ray : accelerators::RaysAt(world, draw, 6)) {
        ray.t_min = 0;
        for (const R3::Ray& one :
             Bundle(draw, ray, draw.Whole(1, 40), draw.Whole(0, 1) ? 0 : draw.Scale(-9, -1), draw.Scale(-9, 0)))
          rays.push_back(one);
      }
      SCOPED_TRACE("seed " + std::to_string(seed + 970) + " powers " + std::to_string(powers));
      Compare(world, rays, ways);
    }
}

TEST(Packets, AgreeAtCornersAndEdgesOfAClosedMesh) {
  const R3::MeshData data = accelerators::BumpyBall(24, 16);
  const ray::Scene scene = SceneOf(data);
  const ray::World world(scene);
  Draw draw(980);
  std::vector<R3::Ray> rays;
  for (int i = 0; i < Count(60, 20000); ++i) {
    const R3::Point eye = R3::Point{} + draw.Scale(0.3, 2) * draw.Direction();
    const auto& triangle =
        data.triangles[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(data.triangles.size()) - 1))];
    for (int k = 0; k < 16; ++k) {  // from one eye at one triangle: its corners, points of its edges
      const R3::Point a = data.positions[triangle[static_cast<std::size_t>(k % 3)]];
      const R3::Point b = data.positions[triangle[static_cast<std::size_t>((k + 1) % 3)]];
      rays.push_back({eye, a + (k < 3 ? 0 : draw.Between(0, 1)) * (b - a) - eye});
    }
  }
  Compare(world, rays, EveryWay());
}

TEST(Packets, AgreeWhenTheyEndOrBeginOrAreNoRays) {
  const ray::Scene scene = SceneOf(accelerators::BumpyBall(24, 16));
  const ray::World world(scene);
  Draw draw(990);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<R3::Ray> rays;
  for (int i = 0; i < Count(40, 4000); ++i) {
    const R3::Point eye = R3::Point{} + draw.Scale(-1, 3) * draw.Direction();
    for (R3::Ray ray : Bundle(draw, {eye, R3::Point{} - eye}, 16, 0, 0.2)) {
      switch (draw.Whole(0, 60)) {
        case 0:
          ray.t_min = draw.Between(0, 2);
          break;
        case 1:
          ray.direction = {};
          break;
        case 2:
          ray.direction.y = nan;
          break;
        case 3:
          ray.direction = {0, -0.0, ray.direction.z};
          break;
        case 4:
          ray.direction = 0x1p-1000 * ray.direction;
          break;
        case 5:
          ray.origin.x = R3::infinity;
          break;
        default:
          break;
      }
      rays.push_back(ray);
    }
  }
  Compare(world, rays, EveryWay());
}

TEST(Packets, AgreeWhenTheyEndWhereTheyHit) {
  const ray::Scene scene = SceneOf(accelerators::BumpyBall(24, 16));
  const ray::World world(scene);
  const auto none = ray::FindAcceleratorKind("none")->Make(world, {});
  ray::Workspace workspace;
  Draw draw(995);
  std::vector<R3::Ray> rays;
  for (int i = 0; i < Count(100, 10000); ++i) {
    const R3::Point eye = R3::Point{} + draw.Scale(-1, 0.5) * draw.Direction();
    for (R3::Ray ray : Bundle(draw, {eye, draw.Direction()}, 16, 0, 0.2))
      if (const auto hit = none->Intersect({ray.origin, ray.direction}, workspace)) {
        const double short_of = draw.Whole(-2, 2) * 0x1p-52;
        rays.push_back({ray.origin, (1 + short_of) * hit->t * ray.direction});  // as shadow rays they end at 1
      }
  }
  Compare(world, rays, EveryWay());
}

}  // namespace
