#include "source/render/SceneFeatures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/Project.h"

namespace ray {
namespace {

const char* const ball = "sphere -1  0 0 0  1";

bool Has(const std::vector<std::string>& words, const std::string& word) { return std::ranges::count(words, word) > 0; }

TEST(SceneFeatures, AReplayHasTheStreamsOfItsRender) {
  const project::Stage stage(project::FromText(ball));
  RenderSettings settings;
  EXPECT_FALSE(Has(FeaturesOf(stage.world, settings).Names(), "two streams"));
  settings.budget.error = ErrorTarget{1};
  EXPECT_TRUE(Has(FeaturesOf(stage.world, settings).Names(), "two streams"));
  settings.replay.emplace();
  EXPECT_FALSE(Has(FeaturesOf(stage.world, settings).Names(), "two streams"));
  settings.replay->two_streams = true;
  EXPECT_TRUE(Has(FeaturesOf(stage.world, settings).Names(), "two streams"));
}

TEST(SceneFeatures, StoppingBlocksEarlyCountsAsBiasInEveryMode) {
  const project::Stage stage(project::FromText(ball));
  RenderSettings settings;
  settings.budget.error = ErrorTarget{1};
  for (const RenderMode mode : {RenderMode::whitted, RenderMode::path, RenderMode::flat, RenderMode::toon}) {
    settings.mode = mode;
    settings.budget.adaptive = Adaptive::automatic;
    EXPECT_TRUE(Has(SourcesOfBias(FeaturesOf(stage.world, settings), settings), "adaptive tile"));
    settings.budget.adaptive = Adaptive::off;
    EXPECT_FALSE(Has(SourcesOfBias(FeaturesOf(stage.world, settings), settings), "adaptive tile"));
  }
}

TEST(CropDifferences, ListSettingsThatDecideByTheWholeImage) {
  using Words = std::vector<std::string>;
  RenderSettings settings;
  settings.budget.error = ErrorTarget{1};
  EXPECT_EQ(CropDifferences(settings), Words{}) << "all of the image is rendered";
  settings.crop = PixelRectangle{0, 0, 9, 9};
  EXPECT_EQ(CropDifferences(settings), Words{"error"});
  settings.budget = {};
  settings.budget.seconds = 3;
  EXPECT_EQ(CropDifferences(settings), Words{"time"});
  settings.budget = {};
  settings.budget.adaptive = Adaptive::neighbors;
  EXPECT_EQ(CropDifferences(settings), Words{});
  settings.replay.emplace();
  EXPECT_EQ(CropDifferences(settings), Words{"replay"});
  settings.replay.reset();
  settings.denoise = true;
  EXPECT_EQ(CropDifferences(settings), Words{});
  settings.denoiser = Denoiser::oidn;
  EXPECT_EQ(CropDifferences(settings), Words{"denoiser oidn"});
  settings.denoise = false;
  EXPECT_EQ(CropDifferences(settings), Words{}) << "nothing is filtered";
}

TEST(SceneFeatures, QuadsAreOneLightInWhittedAndTwoInPath) {
  const project::Stage stage(project::FromText(
      "point_light 0 0 0  0 0 0  1 0 0 material 0 0 0  0 0 0  0 0 0  0 0 0  1 1 1  1 1 0 "
      "quad 0  0 0 0  1 0 0  1 1 0  0 1 0"));
  RenderSettings settings;
  settings.trace.lights = 1;
  EXPECT_FALSE(Has(FeaturesOf(stage.world, settings).Names(), "choice of lights"));
  settings.mode = RenderMode::path;
  EXPECT_TRUE(Has(FeaturesOf(stage.world, settings).Names(), "choice of lights"));
  settings.trace.emission = Emission::color;
  EXPECT_FALSE(Has(FeaturesOf(stage.world, settings).Names(), "choice of lights"));
}

}  // namespace
}  // namespace ray
