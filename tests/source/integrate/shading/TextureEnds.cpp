// Textures at the ends of v on each shape, as rays see them.

#include <gtest/gtest.h>

#include <string>

#include "source/integrate/shading/ShadingPoint.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// Six columns and four rows of different colors, so that half a turn is a whole number of columns.
std::shared_ptr<const Texture> Patches(int columns = 6) {
  R2::Image image(columns, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < columns; ++x) image.Set(x, y, {0.1 * x, 0.2 * y, (x * 5 + y * 3) % 7 / 7.0});
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

R2::Color Seen(const std::string& shape, const R3::Ray& ray, std::shared_ptr<const Texture> texture) {
  Scene scene = project::FromText("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 " + shape);
  scene.materials.back().texture = std::move(texture);
  const project::Stage stage(std::move(scene));
  const auto accelerator = FindAcceleratorKind("none")->Make(stage.world, {});
  Workspace workspace;
  const auto hit = accelerator->Intersect(ray, workspace);
  return hit ? ShadingPointAt(stage.world, ray, {}, *hit).kd : R2::Color{-1, -1, -1};
}

double Distance(const R2::Color& a, const R2::Color& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// A ball, and cones with the apex towards +z, one of them flat.
constexpr const char* poles[] = {"sphere 0  0 0 0  1",
                                 "begin -1  1 0 0 0  0 0 -1 0  0 1 0 0  0 0 0 1 cone 0  0 0 0  1 1 end",
                                 "begin -1  1 0 0 0  0 0 -1 0  0 1 0 0  0 0 0 1 cone 0  0 0 0  3 .1 end"};

// Across a pole, the texture continues in the same row, half a turn further: nothing jumps.
TEST(TextureEnds, AtAPoleColorsAreThoseOfBothSides) {
  for (const char* shape : poles)
    for (const int columns : {6, 5, 1})
      for (int turn = 0; turn < 12; ++turn) {
        const double angle = 0.3 + turn, step = 1e-7;
        const auto seen = [&](double side) {
          return Seen(shape, {{side * step * std::cos(angle), side * step * std::sin(angle), 3}, {0, 0, -1}},
                      Patches(columns));
        };
        EXPECT_LT(Distance(seen(1), seen(-1)), 1e-5) << shape << " " << columns << " " << turn;
      }
}

// At the pole itself the color is the mean of the last row, here and half a turn further; u is 0 there.
TEST(TextureEnds, APoleShowsItsOwnRow) {
  const auto texture = Patches();
  const auto row = [&](int y) {
    return 0.25 *
           (texture->image.At(0, y) + texture->image.At(5, y) + texture->image.At(2, y) + texture->image.At(3, y));
  };
  EXPECT_LT(Distance(Seen(poles[0], {{0, 0, 3}, {0, 0, -1}}, texture), row(3)), 1e-7);
  EXPECT_LT(Distance(Seen(poles[0], {{0, 0, -3}, {0, 0, 1}}, texture), row(0)), 1e-7);
  EXPECT_LT(Distance(Seen(poles[1], {{0, 0, 3}, {0, 0, -1}}, texture), row(3)), 1e-7);
}

// u is 1/4 at +x, the middle of column 1 of six.
TEST(TextureEnds, ARimShowsItsOwnRow) {
  const auto texture = Patches();
  const auto seen = [&](const char* shape, double y) { return Seen(shape, {{5, y, 0}, {-1, 0, 0}}, texture); };
  EXPECT_LT(Distance(seen("cylinder 0  0 0 0  1 2", 1 - 1e-9), texture->image.At(1, 3)), 1e-7);
  EXPECT_LT(Distance(seen("cylinder 0  0 0 0  1 2", -1 + 1e-9), texture->image.At(1, 0)), 1e-7);
  EXPECT_LT(Distance(seen("cone 0  0 0 0  1 2", -1 + 1e-9), texture->image.At(1, 0)), 1e-7);
}

// If coordinates do not show where a surface ends, and around the tube of a torus, rows repeat.
TEST(TextureEnds, ElsewhereTheFirstRowFollowsTheLast) {
  const auto texture = Patches(1);
  const R2::Color both = 0.5 * (texture->image.At(0, 0) + texture->image.At(0, 3));
  EXPECT_LT(Distance(Seen("torus 0  0 0 0  2 1", {{0, 1e-9, 0}, {1, 0, 0}}, texture), both), 1e-7);
  EXPECT_LT(Distance(Seen("quad 0  -1 -1 0  1 -1 0  1 1 0  -1 1 0", {{.3, -1 + 1e-9, 1}, {0, 0, -1}}, texture), both),
            1e-7);
  EXPECT_LT(Distance(Seen("box 0  -1 -1 -1  1 1 1", {{.3, -1 + 1e-9, 5}, {0, 0, -1}}, texture), both), 1e-7);
  EXPECT_LT(Distance(Seen("plane 0  0 0 0  0 0 1", {{0, 0, 1}, {0, 0, -1}}, texture), both), 1e-7);
}

}  // namespace
}  // namespace ray
