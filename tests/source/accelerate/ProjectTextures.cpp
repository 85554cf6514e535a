// Images on polygons and meshes without texture coordinates.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/Named.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// A wall from (-1, -1, 0) to (2, 1, 0) as a polygon; as a mesh; and as one whose texture coordinates are x and y.
const std::string polygon = "polygon 0 4  -1 -1 0  2 -1 0  2 1 0  -1 1 0\n";
const std::string wall = "v -1 -1 0\nv 2 -1 0\nv 2 1 0\nv -1 1 0\n";
const std::string faces = "f 1 2 3\nf 1 3 4\n";
const std::string uvs_and_faces = "vt -1 -1\nvt 2 -1\nvt 2 1\nvt -1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

class Pictures {
 public:
  Pictures() {
    folder_.Write("patches.ppm", "P3 3 2 255 250 10 60  80 200 90  30 60 240  120 120 10  255 255 255  5 90 160 ");
    folder_.Write("bare.obj", wall + faces), folder_.Write("mapped.obj", wall + uvs_and_faces);
  }

  project::Stage Stage(const std::string& text) const {
    folder_.Write("in.scn",
                  "camera look_at .5 0 5 .5 0 0 0 1 0 40  dir_light 1 1 1 -1 -2 -3  background .2 .4 .6\n"
                  "material .1 .1 .1 1 1 1 .3 .3 .3 0 0 0 0 0 0 10 1 patches.ppm\n" +
                      text);
    return project::Stage(folder_ / "in.scn");
  }
  R2::Image operator()(const std::string& text, const std::string& mode = "whitted") const {
    RenderSettings settings = project::Sized(40);
    settings.mode = project::Named{mode};
    return project::Render(Stage(text), settings).image;
  }

 private:
  Folder folder_;
};

double Farthest(const R2::Image& a, const R2::Image& b) {
  double farthest = 0;
  for (std::size_t i = 0; i < a.Channels().size(); ++i)
    farthest = std::max(farthest, double{std::abs(a.Channels()[i] - b.Channels()[i])});
  return farthest;
}

TEST(ProjectTextures, PolygonsAndMeshesAreTexturedByPosition) {
  const Pictures picture;
  for (const std::string more : {"", "bump 0 patches.ppm .2\n", "normal_map 0 patches.ppm\n",
                                 "specular_map 0 patches.ppm\n", "texture_scale 0 2 .5\n"})
    for (const char* mode : {"whitted", "path", "uv"}) {
      const R2::Image expected = picture(more + "mesh 0 mapped.obj\n", mode);
      for (const std::string& shape : {polygon, std::string("mesh 0 bare.obj\n")}) {
        EXPECT_LT(Farthest(picture(more + "texture_project 0\n" + shape, mode), expected), 1e-6)
            << more << mode << shape;
        EXPECT_GT(Farthest(picture(more + shape, mode), expected), 0.1) << more << mode << shape;
      }
    }
}

// Without texture coordinates all of them are 0, as in the course.
TEST(ProjectTextures, UnprojectedPolygonsShowTheColorAtTheOrigin) {
  const Pictures picture;
  EXPECT_EQ(picture(polygon, "uv").At(20, 20), R2::Color{});
  const R2::Image image = picture(polygon, "albedo");
  const R2::Color middle = image.At(20, 20);
  const double red = (250 + 30 + 120 + 5) / 4.0 / 255, green = (10 + 60 + 120 + 90) / 4.0 / 255;
  EXPECT_NEAR(middle.r, red + 0.3, 1e-6);  // and ks
  EXPECT_NEAR(middle.g, green + 0.3, 1e-6);
  EXPECT_EQ(image.At(15, 22), middle);
}

TEST(ProjectTextures, ShapesWithTextureCoordinatesKeepThem) {
  const Pictures picture;
  for (const std::string shape : {"sphere 0 0 0 0 1\n", "box 0 -1 -1 -1 1 1 0\n", "mesh 0 mapped.obj\n",
                                  "tri 0 -1 -1 0 2 -1 0 0 1 0\n", "quad 0 -1 -1 0 2 -1 0 2 1 0 -1 1 0\n"})
    EXPECT_TRUE(picture("texture_project 0\n" + shape) == picture(shape)) << shape;
}

// An image is attached to its object, whether its corners are transformed to the world or rays to it.
TEST(ProjectTextures, AnImageIsTurnedAndScaledWithItsGroup) {
  const Pictures picture;
  const std::string group = "begin 0 scale .7 rotate 30 0 0 1 translate .4 .1 0\n";
  for (const std::string more : {"", "bump 0 patches.ppm .2\n"})
    for (const bool is_shared : {false, true}) {
      const auto twice = [&](const std::string& mesh) {
        const std::string behind_the_eye = "begin 0 translate 0 0 9 mesh 0 " + mesh + " end\n";
        return group + "mesh 0 " + mesh + " end\n" + (is_shared ? behind_the_eye : "");
      };
      const R2::Image expected = picture(more + twice("mapped.obj"));
      EXPECT_LT(Farthest(picture(more + "texture_project 0\n" + twice("bare.obj")), expected), 1e-6)
          << more << is_shared;
    }
}

TEST(ProjectTextures, OneMeshMayHavePlainAndProjectedMaterials) {
  const Pictures picture;
  const project::Stage stage = picture.Stage(
      "material .1 .1 .1 1 1 1 .3 .3 .3 0 0 0 0 0 0 10 1 patches.ppm texture_project 1\n"
      "mesh 0 bare.obj  begin 1 translate 0 0 -1 mesh 1 bare.obj mesh -1 bare.obj end\n");
  ASSERT_EQ(stage.world.Instances().size(), 3u);
  const auto mesh = [&](std::size_t i) { return stage.world.Instances()[i].mesh; };
  EXPECT_FALSE(mesh(0)->HasTextureCoordinates());
  EXPECT_TRUE(mesh(1)->HasTextureCoordinates());
  EXPECT_EQ(mesh(1), mesh(2)) << "shared";
}

}  // namespace
}  // namespace ray
