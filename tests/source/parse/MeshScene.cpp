#include "source/parse/MeshScene.h"

#include <gtest/gtest.h>

#include "R3/Mesh.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

const std::string tall_off = "OFF\n4 4 0\n5 0 5\n6 0 5\n5 0 6\n5 9 5\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
const std::string flat_off = "OFF\n4 4 0\n5 0 5\n16 0 5\n5 0 16\n5 1 5\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";

/// Renders every surface except the ground in white, and the ground and the background in black.
R2::Image Silhouette(const std::filesystem::path& file, int width, int height) {
  ParseOptions options;
  options.aspect = static_cast<double>(width) / height;
  Scene scene = Parse(file, options).scene;
  scene.background = {};
  for (const Node& node : scene.root.children) {
    Material& material = scene.materials[static_cast<std::size_t>(node.material)];
    const bool is_ground = !dynamic_cast<const R3::Mesh*>(node.shape.get());
    material = {};
    material.color = is_ground ? R2::Color{} : R2::Color{1, 1, 1};
  }
  RenderSettings settings = project::Sized(width, height);
  settings.mode = RenderMode::flat;
  return project::Render(project::Stage(std::move(scene)), settings).image;
}

TEST(MeshScene, ShowsTheWholeModelForAnyAspect) {
  const Folder folder;
  folder.Write("tall.off", tall_off);
  folder.Write("flat.off", flat_off);
  for (const char* name : {"tall.off", "flat.off"})
    for (const auto& [width, height] : {std::pair{60, 60}, {100, 50}, {50, 100}}) {
      const R2::Image image = Silhouette(folder / name, width, height);
      int seen = 0, at_edge = 0, low = height, high = 0, left = width, right = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          if (!(image.At(x, y).g > 0)) continue;
          ++seen;
          at_edge += x == 0 || y == 0 || x == width - 1 || y == height - 1;
          low = std::min(low, y), high = std::max(high, y), left = std::min(left, x), right = std::max(right, x);
        }
      EXPECT_GT(seen, 0);
      EXPECT_EQ(at_edge, 0) << name << " " << width;
      // One of the two sides determines the distance of the camera.
      EXPECT_GT(std::max(static_cast<double>(high - low) / height, static_cast<double>(right - left) / width), 0.4);
    }
}

TEST(MeshScene, HasAGroundBelowTheModelAndASkyAbove) {
  const Folder folder;
  const Scene scene = Parse(folder.Write("tall.off", tall_off), {}).scene;
  ASSERT_EQ(scene.root.children.size(), 2u);
  EXPECT_FALSE(scene.root.children[1].shape->IsBounded());
  const R3::Ray down{{5.1, 1, 5.1}, {0, -1, 0}};
  const auto ground = scene.root.children[1].shape->Intersect(down, 0);
  ASSERT_TRUE(ground);
  EXPECT_GT(ground->t, 1) << "the model stands on it and does not lie in it";
  EXPECT_LT(ground->t, 1.01);
  const R2::Image image = project::Render(project::Stage(folder / "tall.off"), project::Sized(16)).image;
  EXPECT_NEAR(image.At(0, 15).b, scene.background.b, 1e-6) << "the horizon is inside a square image";
  EXPECT_LT(image.At(0, 0).b, 0.9 * scene.background.b);
}

TEST(MeshScene, ModelsOfPrintersStandUprightInZ) {
  const Folder folder;
  const std::string stl =
      "solid\nfacet normal 0 0 1 outer loop vertex 0 0 2 vertex 1 0 2 vertex 0 1 3 endloop endfacet\nendsolid\n";
  const Scene scene = Parse(folder.Write("a.stl", stl), {}).scene;
  EXPECT_GT(scene.camera.up.z, 0.9);
  EXPECT_LT(scene.camera.towards.y * -1, 0) << "seen from -y";
  EXPECT_GT(Parse(folder.Write("a.off", tall_off), {}).scene.camera.up.y, 0.9);
}

TEST(MeshScene, AMeshWithoutAMaterialIsDiffuseGray) {
  const Folder folder;
  const Scene scene = Parse(folder.Write("tall.off", tall_off), {}).scene;
  const Material& m = scene.materials[static_cast<std::size_t>(scene.root.children[0].material)];
  EXPECT_EQ(m.kd.r, m.kd.g);
  EXPECT_EQ(m.ks, (R2::Color{}));
  EXPECT_EQ(m.kr, (R2::Color{}));
}

TEST(MeshScene, WithoutAFaceHasTheDefaultCameraAndLights) {
  const Folder folder;
  const ParsedScene parsed = Parse(folder.Write("a.off", "OFF 1 0 0\n0 0 0\n"), {});
  EXPECT_TRUE(parsed.scene.has_default_camera);
  EXPECT_TRUE(parsed.scene.has_default_lights);
}

TEST(MeshScene, NamesTheFilesThatTheModelNames) {
  const Folder folder;
  folder.Write("a.mtl", "newmtl a\nKd 1 0 0\n");
  const auto file = folder.Write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const Scene scene = Parse(file, {}).scene;
  EXPECT_EQ(scene.files, (std::vector<std::string>{file.string(), (folder / "a.mtl").string()}));
}

}  // namespace
}  // namespace ray
