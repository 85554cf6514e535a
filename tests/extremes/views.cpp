// Cameras and objects in unlikely places, and pictures of unlikely shapes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "R2/ImageFile.h"
#include "source/app/options/SceneSettings.h"
#include "source/scene/CameraKind.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace {

/// Not -1 of the scene's first material but gray; black light, so that no other is put in.
const std::string gray = "point_light 0 0 0 9 9 9 1 0 0\nmaterial .2 .2 .2  .6 .6 .6  .3 .3 .3  0 0 0  0 0 0  20 1 0\n";

R2::Image Picture(const std::string& scene, int width, int height, ray::RenderMode mode = ray::RenderMode::whitted,
                  int samples = 1) {
  const project::Stage stage(project::FromText(scene));
  ray::RenderSettings settings = project::Sized(width, height);
  settings.mode = mode;
  settings.samples = samples;
  settings.trace.max_depth = 20;
  return project::Render(stage, settings).image;
}

bool IsFinite(const R2::Image& image) {
  return std::ranges::all_of(image.Channels(), [](float x) { return std::isfinite(x); });
}

TEST(Extremes, G7_CamerasInsideOrOnAnythingGiveFiniteImages) {
  const char* const shapes[] = {"sphere 0 0 0 0 1",    "box 0 -1 -1 -1 1 1 1",      "cylinder 0 0 0 0 1 2",
                                "cone 0 0 0 0 1 2",    "torus 0 0 0 0 .7 .3",       "tri 0 0 0 0 1 0 0 0 1 0",
                                "plane 0 0 0 0 0 0 1", "tri 0 -1 -1 0 1 -1 0 0 1 0"};
  const char* const eyes[] = {"0 0 0", "0 0 1", "1 1 1", "0 1 0", "1 0 0", ".7 0 0", "0 0 .3", "0 -1 0"};
  const char* const lights[] = {"point_light 1 1 1 0 0 0 0 0 1\n", "point_light 1 1 1 0 0 1 0 0 1\n",
                                "sphere_light 1 1 1 0 0 0 2 1 0 0\n", "area_light 1 1 1 0 0 0 0 0 1 1 1 0 0\n"};
  for (const char* shape : shapes)
    for (const char* eye : eyes)
      for (const char* light : lights)
        for (const ray::RenderMode mode : {ray::RenderMode::whitted, ray::RenderMode::path}) {
          const std::string scene = std::string("camera ") + eye + " 0 .1 -1 0 1 0 .6 .01 9\n" + light + gray + shape;
          ASSERT_TRUE(IsFinite(Picture(scene, 6, 6, mode))) << scene;
        }
}

TEST(Extremes, F8_NestedGlassInWaterGainsNoLight) {
  // Clear through and through in light of 1 from everywhere: whatever is seen is at most 1, and 1 where a path ends.
  const std::string clear =
      "background 1 1 1\npoint_light 0 0 0 9 9 9 1 0 0\n"
      "material 0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 1 1.33 0\nmaterial 0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 1 1.5 0\n";
  const std::string nested = "box 0 -3 -3 -3 3 3 3\nsphere 1 0 0 0 2\nsphere 1 0 0 0 1\nbox 1 -1 -1 -3 1 1 -2\n";
  for (const char* eye : {"0 0 9", "0 0 2.5", "0 .2 1.5", "0 0 0", "3 3 3"})
    for (const ray::RenderMode mode : {ray::RenderMode::whitted, ray::RenderMode::path}) {
      const R2::Image image =
          Picture(std::string("camera ") + eye + " 0 .1 -1 0 1 0 .5 .01 99\n" + clear + nested, 24, 24, mode, 2);
      int full = 0;
      for (const float x : image.Channels()) {
        ASSERT_TRUE(x >= 0 && x <= 1 + 1e-6) << eye << ' ' << x;
        full += x > 1 - 1e-6;
      }
      EXPECT_GT(full, 24 * 24) << eye;  // of three channels
    }
}

TEST(Extremes, G3_ImagesOfOneRowColumnOrPixelAreCorrect) {
  const std::string scene = "camera 0 0 5 0 0 -1 0 1 0 .4 .1 100\ndir_light 1 1 1 -1 -1 -2\n" + gray +
                            "sphere 0 0 0 0 1\nbox 0 -2 -2 -1 -1 2 0\n";
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 77}, {77, 1}, {65'535, 1}, {1, 65'535}}) {
    const R2::Image image = Picture(scene, width, height);
    EXPECT_EQ(image.Width(), width);
    EXPECT_EQ(image.Height(), height);
    EXPECT_TRUE(IsFinite(image));
  }
  const R2::Image many = Picture(scene, 64, 64), one = Picture(scene, 1, 1, ray::RenderMode::whitted, 4096);
  double mean = 0, square = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double shown = many.At(x, y).g;
      mean += shown / 4096;
      square += shown * shown / 4096;
    }
  EXPECT_GT(mean, 0.05);
  // Four standard errors of the difference, had the samples been independent.
  const double tolerance = 4 * std::sqrt((square - mean * mean) * 2 / 4096);
  EXPECT_NEAR(one.At(0, 0).g, mean, tolerance);  // both have 4096 samples over the picture
}

TEST(Extremes, G9_FormatsOfLightKeepAnyValueAndOthersClampIt) {
  const std::vector<double> values{0, -0.0, 1e-45, 1e-30, 0.5, 1, 1.5, 1000, 1e38, -2};
  R2::Image image(static_cast<int>(values.size()), 1);
  for (int x = 0; x < image.Width(); ++x) {
    const double v = values[static_cast<std::size_t>(x)];
    image.Set(x, 0, {v, v, v});
  }
  int exact = 0, clamped = 0;
  for (const R2::ImageFormat& format : R2::ImageFormats()) {
    const std::string name = format.name;
    if (name == "hdr" || name == "jpeg") continue;  // lose digits by what they are
    const R2::Image read = R2::DecodeImage(format.encode(image, {}, {})).image;
    for (int x = 0; x < image.Width(); ++x) {
      const double v = values[static_cast<std::size_t>(x)], shown = read.At(x, 0).g;
      if (format.is_linear)
        EXPECT_EQ(shown, static_cast<double>(static_cast<float>(v))) << name << ' ' << v;
      else
        EXPECT_NEAR(shown, v < 0 ? 0 : v > 1 ? 1 : v, 0.5 / 255 + 1e-7) << name << ' ' << v;
    }
    ++(format.is_linear ? exact : clamped);
  }
  EXPECT_GE(exact, 1);
  EXPECT_GE(clamped, 3);
}

/// Pixels that differ though no pixel within `reach` of them lies at the outline of the first picture.
int DifferentAwayFromOutlines(const R2::Image& a, const R2::Image& b, int reach) {
  const auto is_hit = [](const R2::Image& image, int x, int y) { return image.At(x, y).g > 0; };
  int count = 0;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x) {
      if (is_hit(a, x, y) == is_hit(b, x, y)) continue;
      bool is_near = false;
      for (int v = std::max(0, y - reach); v <= std::min(a.Height() - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(a.Width() - 1, x + reach); ++u)
          is_near |= is_hit(a, u, v) != is_hit(a, x, y);
      count += !is_near;
    }
  return count;
}

TEST(Extremes, B11_OutlinesLookTheSameFromATrillionAway) {
  const auto seen_from = [](double distance) {
    const std::string half_angle = "1.5e-" + std::to_string(std::lround(std::log10(distance))),
                      eye = std::to_string(distance);
    return Picture("camera 0 0 " + eye + " 0 0 -1 0 1 0 " + half_angle + " 1 " + eye + "\nambient 1 1 1\n" + gray +
                       "sphere 0 0 0 0 1\nbox 0 -1.2 -1.2 -.1 -.8 -.2 .1\ncylinder 0 .9 .7 0 .2 .9\n",
                   80, 80);
  };
  const R2::Image near = seen_from(1e4);
  EXPECT_GT(std::ranges::count_if(near.Channels(), [](float x) { return x > 0; }), 80 * 80);
  for (const double distance : {1e6, 1e9, 1e12}) {
    const R2::Image far = seen_from(distance);
    EXPECT_TRUE(IsFinite(far));
    EXPECT_EQ(DifferentAwayFromOutlines(near, far, 2), 0) << distance;
  }
}

TEST(Extremes, B12_AMillionSizesFromTheOriginNoGrayLevelChanges) {
  const auto at = [](double offset) {
    const auto x = [&](double place) { return std::to_string(offset + place) + " "; };
    return Picture("camera " + x(0) + x(0.5) + x(5) + " 0 -.1 -1 0 1 0 .4 .1 100\npoint_light 1 1 1 " + x(3) + x(4) +
                       x(5) + "1 0 0\n" + gray + "sphere 0 " + x(0) + x(0) + x(0) + "1\nbox 0 " + x(-2) + x(-1.2) +
                       x(-2) + x(2) + x(-1) + x(2) + "\ncone 0 " + x(1) + x(-.5) + x(1) + ".4 1\n",
                   64, 64);
  };
  const R2::Image near = at(0), far = at(1e6);
  int different = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) different += std::abs(near.At(x, y).g - far.At(x, y).g) >= 1 / 255.0;
  EXPECT_LE(different, 3);  // rays at an outline may pass on its other side
  EXPECT_TRUE(IsFinite(at(1e9)));
}

TEST(Extremes, J7_AThousandRendersAreOneImage) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = ray::FindAcceleratorKind("bvh")->Make(stage.world, {});
  ray::RenderSettings settings = project::Sized(10);
  settings.samples = 2;
  settings.trace.shadow_samples = 2;
  const R2::Image first = ray::Render(stage.world, *accelerator, settings).image;
  for (int i = 0; i < 1000; ++i) {
    settings.threads = 1 + i % 5;
    settings.tile_size = 1 + i % 11;
    ASSERT_TRUE(ray::Render(stage.world, *accelerator, settings).image == first) << i;
  }
}

// Surfaces that are nearer to one another than the errors of both, at most 2^-45 here, are one, and the first of them
// is hit; those at no less than twice that are told apart.
TEST(Extremes, B9_TheNearerOfTwoParallelSquaresIsHit) {
  for (const double size : {1.0, 1e-3, 1e6}) {
    for (int power = 1; power <= 52; ++power) {
      const double gap = std::ldexp(size, -power);
      ray::Scene scene;
      for (const double z : {-gap, 0.0}) {  // the nearer has the higher id
        R3::MeshData data;
        data.positions = {{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}};
        data.triangles = {{0, 1, 2}, {0, 2, 3}};
        scene.root.children.push_back(accelerators::Leaf(std::make_shared<R3::Mesh>(std::move(data))));
      }
      SetBounds(scene.root);
      const ray::World world(scene);
      Draw draw(9);
      for (const char* kind : {"none", "bvh", "grid", "octree"}) {
        const auto accelerator = ray::FindAcceleratorKind(kind)->Make(world, {.name = kind});
        ray::Workspace workspace;
        for (int i = 0; i < 20; ++i) {
          const R3::Ray ray{{size * draw.Between(-.5, .5), size * draw.Between(-.5, .5), size},
                            {0.2 * draw.Between(-1, 1), 0.2 * draw.Between(-1, 1), -1}};
          const auto hit = accelerator->Intersect(ray, workspace);
          ASSERT_TRUE(hit);
          if (power > 44 && power < 50) continue;
          ASSERT_EQ(hit->instance, power <= 44 ? 1u : 0u) << kind << " gap 2^-" << power << " of " << size;
        }
      }
    }
  }
}

/// Why a scene is refused for its settings; empty where it is not.
std::string RefusalOf(const std::string& scene) {
  return project::MessageOf<std::exception>(
      [&] { ray::WithSettingsOf(project::FromText(scene), ray::RenderOptions()); });
}

TEST(Extremes, G11_LensesGiveFiniteImagesOrAreRefused) {
  const std::string room =
      gray + "point_light 1 1 1 1 2 3 1 0 0\nbackground .3 .4 .5\nsphere 0 0 0 0 1\nbox 0 -9 -2 -9 9 -1 9\n";
  for (const ray::CameraKind* kind : ray::CameraKinds())
    for (const double aperture : {1e-300, 1e-9, 0.1, 1e3, 1e150})
      for (const double focus : {1e-300, 1e-6, 6.0, 1e12, 1e300}) {
        std::ostringstream scene;
        scene << "camera 0 0 6 0 0 -1 0 1 0 .5 .01 100\nprojection " << kind->name << "\nset aperture " << aperture
              << "\nset focus " << focus << '\n' << room;
        const std::string refusal = RefusalOf(scene.str());
        const std::string message = "-aperture has no effect with -projection " + std::string(kind->name);
        EXPECT_EQ(refusal.find(message) != std::string::npos, !kind->has_lens) << scene.str() << refusal;
        EXPECT_EQ(refusal.empty(), kind->has_lens) << scene.str() << refusal;
        if (!kind->has_lens) continue;
        const project::Stage stage(project::FromText(scene.str()));
        ray::RenderSettings settings = project::Sized(12, 8);
        settings.samples = 4;
        settings.camera.aperture = aperture, settings.camera.focus = focus;
        EXPECT_TRUE(IsFinite(project::Render(stage, settings).image)) << scene.str();
      }
}

}  // namespace
