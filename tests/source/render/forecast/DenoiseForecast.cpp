#include "source/render/forecast/DenoiseForecast.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/render/ImageDenoiser.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings SettingsToForecast(int samples) {
  RenderSettings settings = project::Sized(128);
  settings.samples = samples;
  settings.denoise = true;
  settings.threads = 1;
  return settings;
}

/// The film of a render, from its checkpoint, and the number of its rays.
struct FilmToForecast {
  Film film;
  std::uint64_t rays = 0;
};

FilmToForecast RenderedFilm(const project::Stage& stage, const Accelerator& accelerator, RenderSettings settings) {
  FilmToForecast exposed{EmptyFilmOf(settings), 0};
  RenderMonitor monitor;
  monitor.saves_finished = true;
  monitor.save = [&](const RenderState& state) {
    for (int i = 0; i < exposed.film.Blocks(); ++i) exposed.film[i] = state.blocks[static_cast<std::size_t>(i)];
    exposed.rays = state.rays.Total();
  };
  settings.budget.error = ErrorTarget{1e-9, ErrorUnit::display};  // never reached: two streams
  settings.budget.adaptive = Adaptive::off;
  settings.denoise = false;
  Render(stage.world, accelerator, settings, monitor);
  return exposed;
}

TEST(DenoiseForecast, KnowsNothingOfGuidesBeforeBothStreamsHaveSamples) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  RenderSettings settings = SettingsToForecast(4);
  settings.budget.seconds_to_filter = 0.25;
  DenoiseForecast forecast(stage.world, *accelerator, settings, {});
  forecast.Look(EmptyFilmOf(settings), 0, 0, nullptr);
  EXPECT_FALSE(forecast.HasLooked());
  EXPECT_EQ(forecast.Seconds(4), 0.25);
  EXPECT_EQ(forecast.SecondsOfSample(4), 0);
}

// Measured by the clock, so that only large deviations are faults: other programs may use the processor. See
// docs/notes/accuracy.md for the accuracy.
TEST(DenoiseForecast, PredictsTheOrderOfMagnitude) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = FindAcceleratorKind("auto")->Make(stage.world, {});
  const RenderSettings settings = SettingsToForecast(16);
  const FilmToForecast exposed = RenderedFilm(stage, *accelerator, settings);
  DenoiseForecast forecast(stage.world, *accelerator, settings, {});
  forecast.Look(exposed.film, 16, exposed.rays, nullptr);
  ASSERT_TRUE(forecast.HasLooked());
  EXPECT_GT(forecast.SecondsOfSample(16), 0);
  EXPECT_GT(forecast.Seconds(32), forecast.Seconds(16));
  EXPECT_LT(forecast.FilterSeconds(), forecast.Seconds(16));
  const RenderResult result = project::Render(stage, settings);
  EXPECT_NEAR(std::log(forecast.Seconds(16) / result.denoise_seconds), 0, std::log(3.0));
}

TEST(DenoiseForecast, FiltersOfMorePixelsTakeLonger) {
  RenderSettings small = SettingsToForecast(4), large = SettingsToForecast(4);
  large.width = large.height = 2048;
  EXPECT_GT(SecondsToFilter(small), 0);
  EXPECT_GT(SecondsToFilter(large), 10 * SecondsToFilter(small));
}

}  // namespace
}  // namespace ray
