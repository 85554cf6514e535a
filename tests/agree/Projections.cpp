// Images of cameras other than pinholes: their geometry, and the agreement of all renderers.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "R2/ImageFile.h"
#include "source/film/error/ImageError.h"
#include "source/render/PixelTrace.h"
#include "source/render/RenderBlock.h"
#include "source/scene/CameraText.h"
#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

/// Every kind other than the pinhole, with a number that suits scenes/fisheye.scn.
std::vector<std::string> Projections() {
  std::vector<std::string> words;
  for (const CameraKind* kind : CameraKinds()) {
    if (!kind->sight) continue;
    words.emplace_back(std::string("projection ") + kind->name);
    if (kind->extent != CameraExtent::none) words.back() += kind->extent == CameraExtent::angle ? " 300" : " 6";
  }
  return words;
}

RenderSettings Settings(int width, int height, int samples = 1) {
  RenderSettings settings = project::Sized(width, height);
  settings.samples = samples;
  return settings;
}

project::Stage RoomWith(const std::string& projection) {
  Scene scene = Parse(project::Root() / "scenes/fisheye.scn", {}).scene;
  const std::string line = CameraLine(scene.camera);
  scene.camera = *ReadCameraLine(line.substr(0, line.find(" projection")) + " " + projection);
  return project::Stage(std::move(scene));
}

bool IsLit(const R2::Color& c) { return Luminance(c) > 0; }

/// Returns the unit direction through the middle of a pixel by the equations of the projection, as right, up and
/// towards.
R3::Vector DirectionOf(const std::string& kind, double x, double y) {
  if (kind == "fisheye") {
    const double angle = std::hypot(x, y) * 150 * pi / 180, around = std::atan2(y, x);
    return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)};
  }
  if (kind == "cylinder") {
    const double angle = x * 150 * pi / 180;
    return Unit(R3::Vector{std::sin(angle), y * 150 * pi / 180, std::cos(angle)});
  }
  return {std::cos(y * pi) * std::sin(x * pi), std::sin(y * pi), std::cos(y * pi) * std::cos(x * pi)};
}

TEST(Projections, ASphereHasTheOutlineOfTheEquations) {
  const R3::Vector center{1.5, 0.75, 1};  // right, up and in front of the eye, which looks along -z
  const double radius = 1.25, half = std::asin(radius / Length(center));
  for (const char* kind : {"fisheye", "cylinder", "latlong"}) {
    const bool has_angle = FindCameraKind(kind)->extent == CameraExtent::angle;
    const project::Stage stage(project::FromText(
        "camera 0 0 0  0 0 -1  0 1 0  .4  .01 100 ambient 1 1 1 sphere -1  1.5 .75 -1  1.25 projection " +
        std::string(kind) + (has_angle ? " 300" : "")));
    const int width = 240, height = 120;
    const R2::Image image = project::Render(stage, Settings(width, height)).image;
    int lit = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const R3::Vector d = DirectionOf(kind, 2 * (x + 0.5) / width - 1, (2 * (y + 0.5) / height - 1) / 2);
        const double angle = std::acos(std::clamp(Dot(d, Unit(center)), -1.0, 1.0));
        if (std::abs(angle - half) < 1e-9) continue;
        lit += angle < half;
        EXPECT_EQ(IsLit(image.At(x, y)), angle < half) << kind << " " << x << " " << y;
      }
    EXPECT_GT(lit, 1000) << kind;
  }
}

TEST(Projections, AnOrthographicSphereIsACircleOfItsRadius) {
  const project::Stage stage(
      project::FromText("camera 0 0 9  0 0 -1  0 1 0  .4  .01 100 ambient 1 1 1 sphere -1  .5 .25 -7  1 "
                        "projection orthographic 4"));
  const R2::Image image = project::Render(stage, Settings(200, 100)).image;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x) {
      const double away = std::hypot((x + 0.5) / 50 - 2 - 0.5, (y + 0.5) / 50 - 1 - 0.25);
      EXPECT_EQ(IsLit(image.At(x, y)), away < 1) << x << " " << y;
    }
}

TEST(Projections, ALatlongImageOfAnEnvironmentIsItsMap) {
  const std::string file = (project::Root() / "scenes/textures/sky.hdr").string();
  ParseOptions options;
  options.environment = file;
  const project::Stage stage(ParseText("camera 3 1 2  0 0 -1  0 1 0  .4  .01 100 projection latlong", options).scene);
  std::ifstream bytes(file, std::ios::binary);
  const std::vector<unsigned char> encoded{std::istreambuf_iterator<char>(bytes), {}};
  const R2::Image map = R2::DecodeImage(encoded).image;
  const R2::Image image = project::Render(stage, Settings(map.Width(), map.Height())).image;
  EXPECT_TRUE(image == map);
}

TEST(Projections, NoRaysAreTracedOutsideAFisheyesCircle) {
  const project::Stage stage = RoomWith("projection fisheye 200");
  const int side = 90;
  const RenderResult result = project::Render(stage, Settings(side, side));
  std::uint64_t inside = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool is_inside = std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0) <= side / 2.0;
      inside += is_inside;
      EXPECT_EQ(IsLit(result.image.At(x, y)), is_inside) << x << " " << y;
    }
  EXPECT_EQ(result.rays[RayKind::camera].rays, inside);
  EXPECT_EQ(result.pixels_done, side * side);
}

TEST(Projections, RaysInPacketsHaveTheHitsOfSingleRays) {
  for (const std::string& projection : Projections()) {
    const project::Stage stage = RoomWith(projection);
    const auto bvh = FindAcceleratorKind("bvh")->Make(stage.world, {});
    const CameraRays camera = CameraRaysOf(stage.world, Settings(64, 64, 4));
    Workspace workspace;
    for (int row = 0; row < 64; ++row) {
      std::vector<R3::Ray> rays;
      for (int column = 0; column < 64; ++column) {
        const CameraSample sample = camera({column, row, RandomKey(1), 2});
        if (sample.HasRay()) rays.push_back(sample.ray);
      }
      std::vector<std::optional<WorldHit>> together(rays.size());
      bvh->Intersect(rays, together.data(), workspace);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto alone = bvh->Intersect(rays[i], workspace);
        ASSERT_EQ(alone.has_value(), together[i].has_value()) << projection;
        if (!alone) continue;
        EXPECT_EQ(alone->t, together[i]->t) << projection;
        EXPECT_EQ(stage.world.PrimitiveId(*alone), stage.world.PrimitiveId(*together[i])) << projection;
      }
    }
  }
}

TEST(Projections, AcceleratorsThreadsAndTilesMakeTheSameImage) {
  for (const std::string& projection : Projections()) {
    const project::Stage stage = RoomWith(projection);
    RenderSettings settings = Settings(50, 40, 2);
    const R2::Image image = project::Render(stage, settings).image;
    settings.threads = 3, settings.tile_size = 8;
    for (const char* accelerator : {"none", "graph", "grid", "octree"})
      EXPECT_TRUE(project::Render(stage, settings, {.name = accelerator}).image == image)
          << projection << " " << accelerator;
  }
}

TEST(Projections, ACropHasThePixelsOfTheWhole) {
  for (const std::string& projection : Projections()) {
    const project::Stage stage = RoomWith(projection);
    RenderSettings settings = Settings(60, 40, 2);
    const R2::Image whole = project::Render(stage, settings).image;
    settings.crop = PixelRectangle{3, 5, 31, 29};
    const R2::Image crop = project::Render(stage, settings).image;
    for (int y = 0; y < crop.Height(); ++y)
      for (int x = 0; x < crop.Width(); ++x) ASSERT_EQ(crop.At(x, y), whole.At(x + 3, y + 5)) << projection;
  }
}

TEST(Projections, TracedPixelsMatchTheImageInEveryMode) {
  for (const std::string& projection : Projections()) {
    const project::Stage stage = RoomWith(projection);
    const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
    for (std::size_t mode = 0; mode < render_modes.size(); ++mode) {
      RenderSettings settings = Settings(24, 24, 2);
      settings.mode = static_cast<RenderMode>(mode);
      if (ShowsCosts(settings.mode)) continue;
      const R2::Image image = ray::Render(stage.world, *accelerator, settings).image;
      for (int i = 0; i < 24; i += 5) {
        const R2::Color traced = PixelTracer(stage.world, *accelerator, settings).Trace(i, i, 2).Mean();
        const R2::Color seen = image.At(i, i);
        EXPECT_NEAR(traced.r, seen.r, 1e-6 * (1 + std::abs(seen.r))) << projection << " " << render_modes[mode];
      }
    }
  }
}

TEST(Projections, TheRayTreeNamesSamplesWithoutARay) {
  const project::Stage stage = RoomWith("projection fisheye 200");
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  const std::string corner = DebugPixel(stage.world, *accelerator, Settings(40, 40, 4), 0, 0);
  EXPECT_TRUE(Contains(corner, "sample 4 at ")) << corner;
  EXPECT_FALSE(Contains(corner, "camera ray")) << corner;
  // The circle's edge crosses this pixel, so that it has samples on both sides.
  const std::string rim = DebugPixel(stage.world, *accelerator, Settings(40, 40, 16), 5, 6);
  EXPECT_TRUE(Contains(rim, "outside the camera's view")) << rim;
  EXPECT_TRUE(Contains(rim, "camera ray")) << rim;
  for (int i = 1; i <= 16; ++i) EXPECT_TRUE(Contains(rim, "sample " + std::to_string(i) + " at ")) << rim;
}

TEST(Projections, TheEstimatedErrorOfAFisheyeIsTrue) {
  const project::Stage stage = RoomWith("projection fisheye 200");
  const R2::Image truth = project::Render(stage, Settings(64, 64, 4096)).image;
  int held = 0, renders = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RenderSettings settings = Settings(64, 64, 64);
    settings.seed = seed;
    settings.budget.error = ErrorTarget{4, ErrorUnit::display};
    const RenderResult result = project::Render(stage, settings);
    ASSERT_TRUE(result.error);
    const double error = TrueError(result.image, truth, nullptr, {.unit = ErrorUnit::display});
    held += error >= result.error->low && error <= result.error->high;
    ++renders;
    EXPECT_LT(error, 2 * result.error->high) << seed;
  }
  EXPECT_GE(held, renders - 1) << "of intervals of 95%";
}

TEST(Projections, OutlinesFollowTheProjectionAndNotItsRim) {
  RenderSettings settings = Settings(80, 80);
  settings.trace.outline.width = 2;
  const project::Stage empty(project::FromText(
      "camera 0 0 0  0 0 -1  0 1 0  .4  .01 100 projection fisheye 200 ambient 1 1 1 sphere -1  0 0 0 5"));
  const R2::Image inside = project::Render(empty, settings).image;
  for (int i = 0; i < 80; ++i) EXPECT_EQ(IsLit(inside.At(i, 40)), true) << "within one ball there is no edge " << i;
  const project::Stage ball(
      project::FromText("camera 0 0 0  0 0 -1  0 1 0  .4  .01 100 background .5 .5 .5 projection fisheye 200 ambient 1 "
                        "1 1 sphere -1  0 0 -4 2"));
  const R2::Image drawn = project::Render(ball, settings).image;
  // The silhouette is asin(2 / 4) from the axis, of 100 degrees in 40 pixels.
  const int edge = static_cast<int>(40 + 40 * 30 / 100.0);
  EXPECT_FALSE(IsLit(drawn.At(edge, 40)) && IsLit(drawn.At(edge - 1, 40)));
  EXPECT_TRUE(IsLit(drawn.At(edge - 4, 40)) && IsLit(drawn.At(edge + 4, 40)));
}

}  // namespace
}  // namespace ray
