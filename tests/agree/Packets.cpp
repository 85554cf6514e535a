// Rays traced in packets have the results of single rays, however coherent they are.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "R3/shapes/Quadric.h"
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

TEST(Packets, AgreeInRandomScenesWhetherCoherentOrNot) {
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

// All rays of a packet visit such trees together, in all directions.
TEST(Packets, AgreeInSmallTreesInAllDirections) {
  const auto ways = EveryWay();
  for (int seed = 0; seed < Count(40, 20000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 1700);
    // Triangles that share corners, are in planes of axes, are thin or large, with lengths from far below 1 to far
    // above.
    R3::MeshData data;
    const double length = draw.Whole(0, 3) ? 1 : draw.Scale(-90, 90);
    const bool is_on_lattice = draw.Whole(0, 1);
    const auto coordinate = [&] { return length * (is_on_lattice ? draw.Whole(-2, 2) : draw.Between(-2, 2)); };
    const int corners = draw.Whole(3, 40);
    for (int i = 0; i < corners; ++i) data.positions.push_back({coordinate(), coordinate(), coordinate()});
    const auto corner = [&] { return static_cast<std::uint32_t>(draw.Whole(0, corners - 1)); };
    for (int i = draw.Whole(1, 60); i > 0; --i) data.triangles.push_back({corner(), corner(), corner()});
    const ray::Scene scene = SceneOf(data);
    const ray::World world(scene);
    const auto on_triangle = [&] {
      const auto& triangle =
          data.triangles[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(data.triangles.size()) - 1))];
      const R3::Point a = data.positions[triangle[0]], b = data.positions[triangle[1]], c = data.positions[triangle[2]];
      const int kind = draw.Whole(0, 2);  // a corner, on an edge, inside
      const double s = kind > 0 ? draw.Between(0, 1) : 0, t = kind > 1 ? draw.Between(0, 1 - s) : 0;
      return a + s * (b - a) + t * (c - a);
    };
    std::vector<R3::Ray> rays;
    for (int i = 0; i < 64; ++i) {
      const R3::Point from = draw.Whole(0, 1) ? on_triangle() : R3::Point{coordinate(), coordinate(), coordinate()};
      R3::Ray ray{from, on_triangle() - from};
      if (draw.Whole(0, 3) == 0) ray.t_max = draw.Whole(0, 1) ? 1 : draw.Between(0, 2);
      if (Length(ray.direction) > 0) rays.push_back(ray);
    }
    SCOPED_TRACE("seed " + std::to_string(seed + 1700));
    Compare(world, rays, ways);
  }
}

/// Returns sixteen rays from one place, outside, on or inside of a sphere, that pass its silhouette within `share` of
/// its radius, or end within that of their hit.
std::vector<R3::Ray> BundleThatGrazes(const R3::Point& center, double radius, double share, Draw& draw) {
  const R3::Vector along = draw.Direction(), across = Unit(Cross(along, draw.Direction())), up = Cross(along, across);
  const double away = draw.Whole(0, 2) ? draw.Scale(0, 1) : 1 + share * draw.Between(-1, 1);  // times the radius
  const R3::Point eye = center - radius * away * along;
  std::vector<R3::Ray> rays;
  for (int i = 0; i < 16; ++i) {
    const double sine = std::min(1.0, 1 / away), cosine = std::sqrt(1 - sine * sine), angle = draw.Between(0, 0.5);
    const R3::Vector outward = std::cos(angle) * across + std::sin(angle) * up;
    const R3::Point silhouette =
        center + radius * (1 + share * draw.Between(-1, 1)) * (cosine * outward - sine * along);
    const R3::Point inside = center + radius * draw.Between(0, 1) * draw.Direction();
    R3::Ray ray{eye, draw.Scale(-1, 1) * ((draw.Whole(0, 1) ? silhouette : inside) - eye)};
    if (draw.Whole(0, 1))
      if (const auto roots = R3::QuadricRoots(eye, ray.direction, center, radius))
        ray.t_max = (draw.Whole(0, 1) ? roots->first : roots->second) * (1 + share * draw.Between(-1, 1));
    if (ray.t_max > 0) rays.push_back(ray);
  }
  return rays;
}

TEST(Packets, AgreeAboutSpheresThatTheyGraze) {
  const auto ways = EveryWay();
  for (int seed = 0; seed < Count(20, 2000); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 1300);
    ray::Scene scene;
    std::vector<R3::Ray> rays;
    for (int i = 0; i < 8; ++i) {
      const R3::Point center = R3::Point{} + draw.Between(0, 3) * draw.Direction();
      const double radius = draw.Scale(-3, 0);
      scene.root.children.push_back(
          accelerators::Leaf(R3::MakeShape("sphere", {center.x, center.y, center.z, radius})));
      for (int k = 0; k < 10; ++k)
        for (const R3::Ray& ray : BundleThatGrazes(center, radius, draw.Scale(-17, -1), draw)) rays.push_back(ray);
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    SCOPED_TRACE("seed " + std::to_string(seed + 1300));
    Compare(world, rays, ways);
  }
}

TEST(Packets, AgreeWhenTheyEndBeginOrAreInvalid) {
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
