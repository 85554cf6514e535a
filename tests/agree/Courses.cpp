// Scenes of other courses match the images that those courses hand out, except for a number of pixels. The scenes and
// their images are not ours to distribute: these tests skip if they are not next to the project.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "R2/Image.h"
#include "tests/Named.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace {

R2::Image ImageIn(const std::string& file) { return ray::testing::Decode(file).image; }

struct Counted {
  int pixels = 0;   // different pixels
  int by_more = 0;  // different by more than `levels`
  double mean = 0;  // over pixels and channels, in levels
};

Counted Compare(const R2::Image& a, const R2::Image& b, int levels) {
  Counted counted;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x) {
      const R2::Color d = 255 * (a.At(x, y) - b.At(x, y));
      const double most = std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)});
      counted.pixels += std::round(most) > 0;
      counted.by_more += std::round(most) > levels;
      counted.mean += (std::abs(d.r) + std::abs(d.g) + std::abs(d.b)) / (3.0 * a.Width() * a.Height());
    }
  return counted;
}

struct Bar {
  const char* scene;
  const char* image;
  std::vector<std::string> options;  // if the image was made with other settings than the file's
  int most_pixels;
  int levels, most_by_more;  // most_by_more may differ by more than `levels`
  double mean = 255;
};

void CheckBar(const std::string& folder, const Bar& bar) {
  const std::filesystem::path course = project::Shared() / folder;
  const ray::testing::TemporaryFolder out;
  std::vector<std::string> words{(course / bar.scene).string(), out / "out.png", "-quiet"};
  words.insert(words.end(), bar.options.begin(), bar.options.end());
  const auto finished = ray::testing::RunProgram(words);
  ASSERT_EQ(finished.status, 0) << finished.error;
  const R2::Image made = ImageIn(out / "out.png"), wanted = ImageIn((course / bar.image).string());
  ASSERT_EQ(made.Width(), wanted.Width());
  ASSERT_EQ(made.Height(), wanted.Height());
  const Counted counted = Compare(made, wanted, bar.levels);
  EXPECT_LE(counted.pixels, bar.most_pixels) << bar.scene;
  EXPECT_LE(counted.by_more, bar.most_by_more) << bar.scene;
  EXPECT_LE(counted.mean, bar.mean) << bar.scene;
}

bool IsAbsent(const std::string& folder) { return !std::filesystem::exists(project::Shared() / folder); }

constexpr int all = 1 << 30;

#ifdef RAYPRO_YAML

// The images named 4 x 4 were made with 2 x 2 samples.
//
// Those with shadows differ for two reasons. A plain program in double precision that implements just these formulas
// differs in the same 102 pixels of the first.
// In 38 pixels the image has only ambient light, where the cosine of the light is below 0.023: in all 21 pixels below
// 0.0051 where it would be visible, and in 17 scattered among about 300 up to 0.025. We add their light. Spheres seem
// to shadow themselves. Shadow rays that begin a distance d inside and count hits from m on, with d = (m^2 + m / 2) /
// 100, darken just those 21 and no others; in double precision rays that count hits from 1e-6 on darken none. In single
// precision, rays from the point that count hits from 0.001 on darken 6 of the 38 and 3 others, rays from the light
// that stop 0.1 before the point 26 and 29 others, and no other offset does better. So rounding may explain the
// scattered ones, but no rule that a scene could state.
// 64 differ by one level, where the formulas give a whole number to within 0.06, mostly 0.005. The signs are mixed, and
// moving hits along the ray by 1e-5 to 1e-2 either way leaves 68 of the oldest image's 71 at best. It looks like
// rounding much coarser than ours, but not simply like single precision, in which the same program agrees with 50 of
// those 71 and differs in 63 others.
// The one pixel of the second image that is 59 levels off is on the ground where the shadow from its second light
// begins: dark there, lit here.
TEST(Courses, GroningensImagesAreMatched) {
  NEEDS_THE_PROGRAM();
  if (IsAbsent("scenes-groningen")) GTEST_SKIP() << "no scenes of Groningen beside the project";
  const std::vector<std::string> four{"-samples", "4"};
  for (const Bar& bar : std::vector<Bar>{
           {"json/scene01.json", "json/scene01_reference.png", {}, 0, 0, 0},
           {"scene01-zbuffer.yaml", "reference/scene01-zbuffer.png", {}, 0, 0, 0},
           {"scene01-gooch.yaml", "reference/scene01-gooch.png", {}, 0, 0, 0},
           {"scene01-shadows.yaml", "reference/scene01-shadows.png", {}, 102, 4, 0},
           {"scene01-lights-shadows.yaml", "reference/scene01-lights-shadows.png", {}, 111, 4, 1},
           {"scene01-ss.yaml", "reference/scene01-ss2x2.png", four, 34, 1, 1},
           {"scene01-camera-ss-reflect-lights-shadows.yaml",
            "reference/scene01-camera-ss2x2-reflect-lights-shadows.png", four, 480, 255, 0},
           {"scene01-dof-ss-reflect-lights-shadows.yaml",
            "reference/scene01-dof-aperture16-ss2x2.png",
            {"-samples", "64", "-lens_samples", "16"},
            all,
            255,
            0,
            0.3},
       })
    CheckBar("scenes-groningen", bar);
}

/// The oldest images aimed at the lower left corners of pixels; all others aim at their middles.
R2::Image OfCorners(const std::string& scene, const std::string& mode) {
  ray::Scene parsed = ray::Parse(project::Shared() / "scenes-groningen" / scene, {}).scene;
  constexpr int side = 400;
  parsed.camera.shift.x -= 1.0 / side;
  parsed.camera.shift.y -= 1.0 / side;
  ray::RenderSettings settings = project::Sized(side);
  settings.mode = project::Named{mode};
  settings.trace.sampler = ray::SamplerKind::grid;
  settings.trace.max_depth = 0;
  settings.trace.shadows = false;
  R2::Image image = project::Render(project::Stage(std::move(parsed)), settings).image;
  const auto level = [](double v) { return R2::ToByte(v, R2::Quantization::truncated) / 255.0; };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const R2::Color c = image.At(x, y);
      image.Set(x, y, {level(c.r), level(c.g), level(c.b)});
    }
  return image;
}

TEST(Courses, GroningensOldestImagesAreMatchedShiftedByHalfAPixel) {
  if (IsAbsent("scenes-groningen")) GTEST_SKIP() << "no scenes of Groningen beside the project";
  const auto reference = [](const char* name) {
    return ImageIn((project::Shared() / "scenes-groningen/reference" / name).string());
  };
  const Counted phong = Compare(OfCorners("scene01.yaml", "whitted"), reference("scene01-phong-2009-pixels.png"), 1);
  EXPECT_LE(phong.pixels, 70) << "whole numbers except for rounding, as in the images with shadows";
  EXPECT_EQ(phong.by_more, 0);
  const Counted normal =
      Compare(OfCorners("scene01-normal.yaml", "normal_color"), reference("scene01-normal-2009-pixels.png"), 1);
  EXPECT_LE(normal.pixels, 12);
  EXPECT_EQ(normal.by_more, 0);
}

#endif

TEST(Courses, Cs315sImagesAreMatched) {
  NEEDS_THE_PROGRAM();
  if (IsAbsent("scenes-cs315")) GTEST_SKIP() << "no scenes of CS 315 beside the project";
  for (const Bar& bar : std::vector<Bar>{
           {"SphereTest.json", "reference/SphereTest.png", {}, 0, 0, 0},
           {"TriangleTest.json", "reference/TriangleTest.png", {}, 0, 0, 0},
           {"TriangleShadingTest.json", "reference/TriangleShadingTest.png", {}, 0, 0, 0},
           {"SphereShadingTest1.json", "reference/SphereShadingTest1.png", {}, 20, 2, 0},
           {"ShadowTest1.json", "reference/ShadowTest1.png", {}, 20, 2, 0},
           {"TransformationTest.json", "reference/TransformationTest.png", {}, 20, 2, 0},
           {"FullTest-floor-fixed.json", "reference/FullTest.png", {}, 165, 255, 0},
           {"CornellBox.json", "reference/CornellBox.png", {}, 135, 255, 0},
       })
    CheckBar("scenes-cs315", bar);
}

}  // namespace
