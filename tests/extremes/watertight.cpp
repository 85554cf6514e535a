// Closed meshes let nothing through, whichever accelerator asks: rays from inside aimed exactly at edges and corners.
// If this fails, pictures get dots of light along edges.

#include <gtest/gtest.h>

#include "tests/Accelerators.h"
#include "tests/extremes/Placements.h"

namespace {

std::vector<accelerators::Way> Ways() {
  std::vector<accelerators::Way> ways;
  for (const auto* kind : ray::AcceleratorKinds()) ways.push_back({kind->name, {.name = kind->name}});
  for (const std::string& set : ray::InstructionSets())
    for (const char* kind : {"grid", "octree", "bvh"})
      ways.push_back({kind + (", " + set), {.name = kind, .instruction_set = set}});
  return ways;
}

ray::Scene SceneOf(R3::MeshData data) {
  ray::Scene scene;
  scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(std::move(data))));
  SetBounds(scene.root);
  return scene;
}

/// `rays` for each accelerator as it comes; a twentieth for other instruction sets, and for those that ask every
/// triangle.
void ExpectNoLeaks(const R3::MeshData& data, const R3::Matrix& matrix, std::uint64_t seed, int rays) {
  const ray::Scene scene = SceneOf(data);
  const ray::World world(scene);
  for (const auto& way : Ways()) {
    Draw draw(seed);
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    const bool is_fewer = way.settings.name == "none" || way.settings.name == "graph" || way.name != way.settings.name;
    ray::Workspace workspace;
    int leaks = 0;
    for (int i = 0; i < (is_fewer ? rays / 20 : rays); ++i) {
      const R3::Point origin = matrix * (R3::Point{} + 0.3 * draw.Between(0, 1) * draw.Direction());
      const auto& t =
          data.triangles[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(data.triangles.size()) - 1))];
      const R3::Point a = data.positions[t[0]], b = data.positions[t[1]];
      const R3::Point target = i % 2 ? a : a + draw.Between(0, 1) * (b - a);
      const R3::Ray ray{origin, target - origin};
      if (accelerator->Intersect(ray, workspace) && accelerator->IsOccluded(ray, workspace)) continue;
      if (++leaks <= 3) ADD_FAILURE() << way.name << " leaks: " << oracle::Hex(ray);
    }
    EXPECT_EQ(leaks, 0) << way.name;
  }
}

TEST(Extremes, D1_D2_NoAcceleratorLeaksAtEdgesOrCorners) {
  ExpectNoLeaks(accelerators::BumpyBall(40, 30), {}, 1001, Count(60'000, 100'000'000));
  ExpectNoLeaks(accelerators::BumpyBall(200, 4), {}, 1002, Count(20'000, 10'000'000));  // corners of valence 200
  ExpectNoLeaks(accelerators::BumpyBall(3, 4), {}, 1003, Count(20'000, 10'000'000));    // and of 3
}

TEST(Extremes, D1_D2_NoAcceleratorThatTracesRaysTogetherLetsOneThrough) {
  const R3::MeshData data = accelerators::BumpyBall(40, 30);
  const ray::Scene scene = SceneOf(data);
  const ray::World world(scene);
  constexpr std::size_t together = 16;
  for (const auto& way : Ways()) {
    if (way.settings.name == "none" || way.settings.name == "graph") continue;  // they trace them one by one
    Draw draw(1004);
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    ray::Workspace workspace;
    int leaks = 0;
    for (int i = 0; i < Count(2'000, 6'250'000); ++i) {
      // From one eye at edges and corners that are near each other.
      const R3::Point eye = R3::Point{} + 0.3 * draw.Between(0, 1) * draw.Direction();
      auto which = static_cast<std::size_t>(draw.Whole(0, static_cast<int>(data.triangles.size()) - 1));
      std::array<R3::Ray, together> rays;
      for (R3::Ray& ray : rays) {
        const auto& t = data.triangles[which];
        which = (which + 1) % data.triangles.size();
        const R3::Point a = data.positions[t[0]], b = data.positions[t[1]];
        ray = {eye, (draw.Whole(0, 1) ? a : a + draw.Between(0, 1) * (b - a)) - eye};
      }
      std::array<std::optional<ray::WorldHit>, together> hits;
      std::array<bool, together> is_occluded{};
      accelerator->Intersect(rays, hits.data(), workspace);
      accelerator->IsOccluded(rays, is_occluded.data(), workspace);
      for (std::size_t k = 0; k < together; ++k) {
        if (hits[k] && is_occluded[k]) continue;
        if (++leaks <= 3) ADD_FAILURE() << way.name << " leaks: " << oracle::Hex(rays[k]);
      }
    }
    EXPECT_EQ(leaks, 0) << way.name;
  }
}

TEST(Extremes, D3_NoAcceleratorLeaksUnderExtremeTransforms) {
  Draw draw(1010);
  for (const R3::Matrix& m : HardPlacements(draw))
    ExpectNoLeaks(Moved(accelerators::BumpyBall(24, 16), m), m, 1011, Count(6'000, 1'000'000));
}

TEST(Extremes, D12_RaysCrossAClosedMeshAnEvenNumberOfTimes) {
  const ray::Scene scene = SceneOf(accelerators::BumpyBall(40, 30));
  const ray::World world(scene);
  for (const auto& way : Ways()) {
    const bool asks_all = way.settings.name == "none" || way.settings.name == "graph";
    Draw draw(1020);
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    ray::Workspace workspace;
    int odd = 0;
    for (int i = 0; i < Count(asks_all ? 1'000 : 20'000, asks_all ? 50'000 : 1'000'000); ++i) {
      const R3::Point origin = R3::Point{} + 3 * draw.Direction(),
                      target = R3::Point{} + draw.Between(0, 1) * draw.Direction();
      R3::Ray ray{origin, target - origin};
      int crossings = 0;
      while (const auto hit = accelerator->Intersect(ray, workspace)) ray.t_min = hit->t, ++crossings;
      odd += crossings % 2;
    }
    EXPECT_EQ(odd, 0) << way.name;
  }
}

TEST(Extremes, E9_NoLightComesThroughASharedEdge) {
  const R3::MeshData data = accelerators::BumpyBall(24, 16);
  const ray::Scene scene = SceneOf(data);
  const ray::World world(scene);
  for (const auto& way : Ways()) {
    const bool asks_all = way.settings.name == "none" || way.settings.name == "graph";
    Draw draw(1030);
    const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(world, way.settings);
    ray::Workspace workspace;
    int lit = 0;
    for (int i = 0; i < Count(asks_all ? 1'000 : 30'000, asks_all ? 100'000 : 10'000'000); ++i) {
      const auto& t =
          data.triangles[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(data.triangles.size()) - 1))];
      const R3::Point edge = data.positions[t[0]] + draw.Between(0, 1) * (data.positions[t[1]] - data.positions[t[0]]);
      const R3::Point inside = R3::Point{} + 0.3 * draw.Between(0, 1) * draw.Direction();
      const R3::Point light = inside + draw.Between(1.5, 4) * (edge - inside);  // exactly behind the edge
      lit += accelerator->IsOccluded({inside, light - inside, 0, 1}, workspace) ? 0 : 1;
    }
    EXPECT_EQ(lit, 0) << way.name;
  }
}

}  // namespace
