#include "source/app/report/ProbeImage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/render/Render.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// Soft light on a ball and a floor: noise in the penumbra and at edges.
constexpr const char* soft =
    "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100\n"
    "area_light 1 1 1  0 4 1  0 -1 0  1  1 0 0\n"
    "material 0 0 0  .8 .8 .8  0 0 0  0 0 0  0 0 0  1 1 0\n"
    "box 0  -4 -.1 -4  4 0 4\nsphere 0  0 .8 0  .8\n";

/// The scene and an acceleration structure for it.
struct Subject {
  project::Stage stage{project::FromText(soft)};
  const World& world = stage.world;
  std::unique_ptr<const Accelerator> accelerator = FindAcceleratorKind("bvh")->Make(world, {});
};

RenderSettings Settings(int width, int height, const ErrorTarget& target) {
  RenderSettings settings = project::Sized(width, height);
  settings.trace.shadow_samples = 1;
  settings.budget.error = target;
  return settings;
}

Probe Probed(const Subject& subject, const RenderSettings& settings, const std::vector<PixelRectangle>& squares,
             double seconds = 1e9) {
  return ProbeToError(subject.world, *subject.accelerator, settings, squares, seconds);
}

TEST(SquaresToProbe, AreDifferentBlocksWithinTheImage) {
  for (const PixelRectangle& image : {PixelRectangle{0, 0, 512, 512}, {10, 20, 250, 230}, {3, 5, 1000, 84}}) {
    const auto squares = SquaresToProbe(image, 32, 9);
    ASSERT_EQ(squares.size(), 9u);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      EXPECT_EQ(Common(squares[i], image), squares[i]);
      EXPECT_TRUE(squares[i].Width() == 32 && squares[i].Height() == 32);
      EXPECT_TRUE(squares[i].x0 % 8 == 0 && squares[i].y0 % 8 == 0);
      for (std::size_t k = 0; k < i; ++k) EXPECT_LE(Common(squares[i], squares[k]).Area(), 0);
    }
  }
}

TEST(SquaresToProbe, SmallOrNarrowImagesAreProbedAsAWhole) {
  for (const PixelRectangle& image : {PixelRectangle{0, 0, 7, 5}, {1, 1, 90, 90}, {0, 0, 500, 31}, {4, 4, 39, 400}})
    EXPECT_EQ(SquaresToProbe(image, 32, 16), std::vector{image});
}

// The schedule, the estimate and its interval equal those of the render, with a wide filter and in a crop too.
TEST(ProbeToError, OfTheWholeImageIsTheRender) {
  const Subject subject;
  for (const FilterKind filter : {FilterKind::box, FilterKind::mitchell})
    for (const ErrorTarget target : {ErrorTarget{1, ErrorUnit::display}, {4, ErrorUnit::relative}}) {
      RenderSettings settings = Settings(80, 70, target);
      settings.filter = filter;
      settings.crop = PixelRectangle{5, 10, 63, 61};
      const Probe probe = Probed(subject, settings, {*settings.crop});
      const RenderResult result = Render(subject.world, *subject.accelerator, settings);
      EXPECT_EQ(probe.stop, Stop::error);
      ASSERT_GE(probe.passes.size(), 2u);
      EXPECT_EQ(probe.passes.back().end, result.passes.back().end);
      EXPECT_NEAR(probe.passes.back().samples, result.samples.mean, 1e-9);
      EXPECT_NEAR(probe.passes.back().error->estimate, result.error->estimate, 1e-3 * result.error->estimate);
      const double high = result.passes.back().error->high;
  EXPECT_NEAR(probe.passes.back().error->high, high, 1e-3 * high);
      EXPECT_NEAR(probe.light, MeanOf(result.image), 1e-5) << "to the precision of the floats of both parts";
      const Probe::Arrival arrival = probe.ArrivalAt(target);
      EXPECT_EQ(arrival.samples, probe.passes.back().samples);
      EXPECT_EQ(arrival.seconds, probe.passes.back().seconds);
    }
}

// A quarter of the blocks predicts the error at 16 samples to a few percent, from the spread between squares.
TEST(ProbeToError, SquaresStandForTheImage) {
  const Subject subject;
  RenderSettings settings = Settings(192, 192, {1e-9, ErrorUnit::display});
  settings.samples = 16;
  const Probe probe = Probed(subject, settings, SquaresToProbe({0, 0, 192, 192}, 8, 144));
  const RenderResult result = Render(subject.world, *subject.accelerator, settings);
  EXPECT_EQ(probe.stop, Stop::samples);
  EXPECT_NEAR(probe.passes.back().error->estimate, result.error->estimate, 0.2 * result.error->estimate);
  EXPECT_NEAR(probe.passes.back().error->freedom, result.error->freedom, 0.3 * result.error->freedom);
  EXPECT_TRUE(std::isinf(probe.ArrivalAt(*settings.budget.error).samples)) << "16 samples do not reach it";
}

TEST(ProbeToError, MeasuresAnErrorInAnyTime) {
  const Subject subject;
  const ErrorTarget target{0.01, ErrorUnit::display};
  const Probe probe = Probed(subject, Settings(96, 96, target), SquaresToProbe({0, 0, 96, 96}, 16, 4), 0);
  EXPECT_EQ(probe.stop, std::nullopt);
  ASSERT_TRUE(probe.passes.back().error);
  const Probe::Arrival arrival = probe.ArrivalAt(target);
  EXPECT_GT(arrival.samples, 100 * probe.passes.back().samples);
  EXPECT_GT(arrival.seconds, probe.passes.back().seconds);
}

TEST(ProbeToError, ADenoisedWholeImageIsTheRender) {
  const Subject subject;
  const ErrorTarget target{1.2, ErrorUnit::display};
  RenderSettings settings = Settings(56, 44, target);
  settings.denoise = true;
  const Probe probe = Probed(subject, settings, {PixelRectangle{0, 0, 56, 44}});
  const RenderResult result = Render(subject.world, *subject.accelerator, settings);
  EXPECT_EQ(probe.stop, Stop::error);
  ASSERT_EQ(probe.passes.back().end, result.passes.back().end);
  const double high = result.passes.back().error->high;
  EXPECT_NEAR(probe.passes.back().error->high, high, 1e-3 * high);
  EXPECT_NEAR(std::sqrt(probe.square) * 255, result.error_before_denoising->estimate,
              1e-3 * result.error_before_denoising->estimate);
}

}  // namespace
}  // namespace ray
