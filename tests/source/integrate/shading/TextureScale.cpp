// Images that repeat by a material's scale equal those that repeat by a mesh's texture coordinates.

#include <gtest/gtest.h>

#include <string>

#include "tests/Farthest.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// A wall of two triangles, not square, over which u runs to `u` and v to `v`.
std::string Wall(double u, double v) {
  const std::string right = std::to_string(u), top = std::to_string(v);
  return "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1 0\nvt 0 0\nvt " + right + " 0\nvt " + right + " " + top + "\nvt 0 " +
         top + "\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
}

class ScaledWall {
 public:
  ScaledWall() {
    folder_.Write("patches.ppm", "P3 3 2 255 250 10 60  80 200 90  30 60 240  120 120 10  255 255 255  5 90 160 ");
    folder_.Write("once.obj", Wall(1, 1)), folder_.Write("often.obj", Wall(3, 0.5));
  }

  R2::Image Rendered(const std::string& mesh, const std::string& more) const {
    folder_.Write("in.scn",
                  "camera look_at 0 0 5 0 0 0 0 1 0 50  dir_light 1 1 1 -1 -2 -3\n"
                  "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 10 1 patches.ppm\n" +
                      more + "\nmesh 0 " + mesh + "\n");
    return project::Render(project::Stage(folder_ / "in.scn"), project::Sized(48)).image;
  }

 private:
  Folder folder_;
};

TEST(TextureScale, RepeatsAllImagesAsTextureCoordinatesDo) {
  const ScaledWall wall;
  for (const std::string relief : {"", "bump 0 patches.ppm .2", "normal_map 0 patches.ppm",
                                   "specular_map 0 patches.ppm mirror 0 .6 .6 .6 background .9 .8 .7"}) {
    const R2::Image plain = wall.Rendered("once.obj", relief), often = wall.Rendered("often.obj", relief);
    EXPECT_LT(Farthest(wall.Rendered("once.obj", relief + " texture_scale 0 3 .5"), often), 1e-6) << relief;
    EXPECT_GT(Farthest(plain, often), 0.1) << relief;
  }
}

// An image that repeats along u alone ends at the pole in its last row.
TEST(TextureScale, RepeatedTexturesAreNotBlendedAcrossPoles) {
  R3::Intersection pole{};
  pole.uv = {0.25, 1}, pole.v_ends = {R3::VEnd::pole, R3::VEnd::pole};
  EXPECT_EQ(PlaceOnTexture(pole, {1, 1}).v_ends.high, R3::VEnd::pole);
  EXPECT_EQ(PlaceOnTexture(pole, {3, 1}).v_ends.high, R3::VEnd::rim);
  EXPECT_EQ(PlaceOnTexture(pole, {1, 2}).v_ends.high, R3::VEnd::repeated);
  EXPECT_EQ(PlaceOnTexture(pole, {3, 2}).uv.x, 0.75);
  EXPECT_EQ(PlaceOnTexture(pole, {3, 2}).uv.y, 2);
}

}  // namespace
}  // namespace ray
