// Light where it can and cannot be.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "R3/Mesh.h"
#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

/// abs(x) + abs(y) + abs(z) = 1, with the normals of a sphere.
std::shared_ptr<const R3::Mesh> SmoothOctahedron() {
  R3::MeshData data;
  data.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const R3::Point& p : data.positions) data.normals.push_back({p.x, p.y, p.z});
  for (const std::uint32_t z : {4u, 5u})
    for (const std::uint32_t x : {0u, 1u})
      for (const std::uint32_t y : {2u, 3u}) {
        const bool turned = ((x == 1) != (y == 3)) != (z == 5);
        data.triangles.push_back(turned ? std::array{y, x, z} : std::array{x, y, z});
      }
  return std::make_shared<R3::Mesh>(std::move(data), true);
}

/// Where the ray through a pixel of the camera at (0, 0, 4), looking along -z with half angles of atan(0.3), meets the
/// front of the octahedron.
std::array<double, 3> PlaceOf(int x, int y, int side) {
  const double u = 0.3 * (2 * (x + 0.5) / side - 1), v = 0.3 * (2 * (y + 0.5) / side - 1);
  // abs(u) t + abs(v) t + 4 - t = 1 at z = 4 - t
  const double t = 3 / (1 - std::abs(u) - std::abs(v));
  return {u * t, v * t, 4 - t};
}

// Light at the horizon of a face once lit it by the smoothed normal, up to .56 of its strength; without shadows from
// anywhere behind.
TEST(Extremes, E8_SmoothNormalsLetNoLightThroughFromBehind) {
  constexpr int side = 96;
  Draw draw(88);
  int behind = 0, lit = 0;
  for (int round = 0; round < 12; ++round) {
    R3::Vector L = draw.Direction();
    if (round < 4)
      L = Unit(R3::Vector{round < 2 ? 1.0 : -1.0, round % 2 ? 1.0 : -1.0, 0});  // the horizon of four faces
    ray::Scene scene =
        project::FromText("camera 0 0 4  0 0 -1  0 1 0  " + std::to_string(std::atan(0.3)) +
                          "  0.1 100\nmaterial 0 0 0  1 1 1  "
                          ".5 .5 .5  0 0 0  0 0 0  3 1 0\ndir_light 1 1 1  " +
                          std::to_string(-L.x) + " " + std::to_string(-L.y) + " " + std::to_string(-L.z) + "\n");
    scene.root.children.push_back(accelerators::Leaf(SmoothOctahedron()));
    scene.root.children.back().material = static_cast<int>(scene.materials.size()) - 1;
    SetBounds(scene.root);
    const project::Stage stage(std::move(scene));
    for (const bool shadows : {true, false})
      for (const ray::RenderMode mode : {ray::RenderMode::whitted, ray::RenderMode::path}) {
        ray::RenderSettings settings = project::Sized(side);
        settings.trace.shadows = shadows;
        settings.trace.max_depth = 0;
        settings.mode = mode;
        const R2::Image image = project::Render(stage, settings).image;
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x) {
            const auto [px, py, pz] = PlaceOf(x, y, side);
            constexpr double edge = 0.02;  // whose pixels may see two faces
            if (pz < edge || std::abs(px) < edge || std::abs(py) < edge) continue;
            // To 6 digits, as the scene has the light's direction.
            const double cosine = std::copysign(L.x, px * L.x) + std::copysign(L.y, py * L.y) + L.z;
            const double shown = image.At(x, y).g;
            lit += cosine > 1e-5 && shown > 0;
            if (cosine > 1e-5) continue;
            ++behind;
            ASSERT_EQ(shown, 0) << x << ' ' << y << (shadows ? " with shadows" : " without shadows");
          }
      }
  }
  EXPECT_GT(behind, 40'000);
  EXPECT_GT(lit, 40'000);
}

}  // namespace
