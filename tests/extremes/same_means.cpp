// I5, I7 and E6: other ways to the same picture.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/Draw.h"
#include "tests/Named.h"
#include "tests/extremes/KnownScenes.h"

namespace statistics {
namespace {

using ray::RenderSettings;
using ray::TraceSettings;

/// A floor, a wall and a ball, diffuse and glossy.
const std::string room =
    "camera 0 1.5 6  0 -0.2 -1  0 1 0  0.35  0.01 100" + Material(0.5, 0.3, 0, 0, 20) + Material(0.7, 0, 0, 0) +
    "tri 0 -9 0 -9  -9 0 9  9 0 9 tri 0 -9 0 -9  9 0 9  9 0 -9 tri 1 -9 0 -3  9 0 -3  0 12 -3 sphere 0 0.8 0.7 0 0.7 ";

std::string Lamps(bool shining_triangles) {
  std::string text =
      "point_light 3 2 1  -2 3 1  0 0 1 area_light 4 4 8  2 4 2  -1 -4 -2  0.7  0 0 1 "
      "sphere_light 1 3 1  -1 1 2  0.3  0 0 1 dir_light 0.1 0.1 0.2  1 -3 -1 "
      "spot_light 9 9 3  0 5 0  0 -1 0  0 0 1  0.5 3 ";
  if (shining_triangles)
    text += Material(0, 0, 0, 6) + "tri 2 -1.5 2 0  -1 2 0.5  -1.5 2.5 0.5 tri 2 1.5 2 0  2 2 0.5  1.5 2.5 0.5 ";
  return text;
}

/// A dim sky with a sun, lighter towards the horizon.
R2::Image SunnySky() {
  R2::Image image = UniformSky(0);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {0.3 + 0.02 * x, 0.4, 0.9 - 0.05 * y});
  for (const int y : {5, 6})
    for (const int x : {10, 11}) image.Set(x, y, {8, 7, 6});
  return image;
}

/// Whether pictures made with both settings have the same means, as far as can be seen: pixel by pixel and as a whole.
void ExpectSameMeans(const std::vector<R2::Image>& a, const std::vector<R2::Image>& b, const std::string& what) {
  const Comparison c = Compare(a, b);
  EXPECT_LE(c.worst_pixel, 1) << what;
  EXPECT_LE(std::abs(c.whole), 4) << what;
  EXPECT_LE(c.deviation, 0.01) << what << ": too noisy to tell anything";
}

constexpr int few = 20;  // pictures of each kind

RenderSettings Compared(const char* mode, int samples) {
  RenderSettings settings = Path(8, Count(samples, 64 * samples));
  settings.mode = project::Named{mode};
  settings.trace.max_depth = 3;
  settings.trace.min_luminance = 0;
  settings.trace.shadow_samples = 1;
  return settings;
}

using Ways = std::vector<std::pair<std::string, RenderSettings>>;

/// Against the first of some settings; each with seeds of its own.
void ExpectAllAlike(const project::Stage& stage, const Ways& settings) {
  const auto first = Pictures(stage, settings[0].second, few, 0);
  for (std::size_t i = 1; i < settings.size(); ++i)
    ExpectSameMeans(first, Pictures(stage, settings[i].second, few, 1000 * i),
                    settings[0].first + " and " + settings[i].first);
}

/// Each strategy for paths that needs no environment, with all lights and with a chosen one.
Ways EveryStrategyAndCountOfLights(bool glossy) {
  Ways ways;
  for (const char* strategy : {"bsdf", "mis", "light"})
    for (const int lights : {0, 1}) {
      ways.emplace_back(std::string(strategy) + (lights > 0 ? ", chosen" : ""), Compared("path", 256));
      TraceSettings& trace = ways.back().second.trace;
      trace.strategy = project::Named{strategy};
      trace.glossy = glossy;
      trace.lights = lights;
    }
  return ways;
}

TEST(Extremes, I5_EveryStrategyFindsTheSameLight) {
  for (const bool glossy : {false, true})
    for (const bool sky : {false, true}) {
      if (glossy == sky && !std::getenv("RAYPRO_NIGHT")) continue;
      const project::Stage stage =
          sky ? StageOf(room + no_light, SunnySky())
              : StageOf(room + no_light + Material(0, 0, 0, 5) + "tri 2 -3 2.5 0  1 3 0  -1 2.5 3 ");
      Ways ways;
      for (const char* strategy : {"mis", "light", "bsdf", "uniform"}) {
        if (!sky && strategy == std::string("uniform")) continue;
        ways.emplace_back(strategy, Compared("path", 256));
        ways.back().second.trace.strategy = project::Named{strategy};
        ways.back().second.trace.glossy = glossy;
      }
      SCOPED_TRACE(std::string(sky ? "sky" : "triangle") + (glossy ? ", glossy" : ""));
      ExpectAllAlike(stage, ways);
    }
}

TEST(Extremes, I5_StrategiesAgreeOnLightsInAPureGlossyMirror) {
  const std::string mirror = "camera 0 1.5 6  0 -0.2 -1  0 1 0  0.35  0.01 100" + Material(0, 0, 0, 0, 2) +
                             "mirror 0 0.8 0.7 0.6 tri 0 -9 0 -9  -9 0 9  9 0 9 tri 0 -9 0 -9  9 0 9  9 0 -9 " +
                             no_light + Material(0, 0, 0, 5);
  for (const std::string lamp :
       {"", "tri 1 -3 2.5 0  1 3 0  -1 2.5 3 ", "sphere 1 0 4 -1  2.5 ",
        "begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1 motion 0.2 0 0 sphere 1 0 4 -1  2.5 end "}) {
    SCOPED_TRACE(lamp.empty() ? "sky" : lamp);
    const project::Stage stage = lamp.empty() ? StageOf(mirror, SunnySky()) : StageOf(mirror + lamp);
    ExpectAllAlike(stage, EveryStrategyAndCountOfLights(true));
  }
}

TEST(Extremes, I5_StrategiesAgreeOnTheFirstOfCoincidentLamps) {
  const std::string floor = "camera 0 1 4  0 -0.25 -1  0 1 0  0.3  0.01 100" + Material(0.5, 0, 0, 0) + no_light +
                            Material(0, 0, 0, 3) + Material(0, 0, 0, 1) + "box 0 -9 -1 -9  9 0 9 ";
  for (const std::string where : {"0 4 0  2.5 ", "-6 2.5 -5  6 2.5 -5  0 2.5 7 "}) {
    SCOPED_TRACE(where);
    const std::string lamp = where.size() < 12 ? "sphere " : "tri ";
    const project::Stage stage = StageOf(floor + lamp + "1 " + where + lamp + "2 " + where);
    ExpectAllAlike(stage, EveryStrategyAndCountOfLights(false));
  }
}

// The mirror's direction and the place on the lamp must not be picked by the same numbers.
TEST(Extremes, I5_ChoosingOneLampKeepsABlurredMirrorsMean) {
  const project::Stage stage =
      StageOf("camera 0 1 0  0 -1 0  0 0 -1  0.02  0.01 100" + Material(0, 0, 0, 0) + "mirror 0 1 1 1 gloss 0 8 1 " +
              Material(1, 0, 0, 0) +
              "quad 0 -1 0 -1  -1 0 1  1 0 1  1 0 -1 quad 1 -9 3 -9  9 3 -9  9 3 9  -9 3 9 "
              "quad 1 0 2.2 -9  0 2.2 9  9 2.2 9  9 2.2 -9 area_light 1 1 1  0 1.5 0  0 1 0  3  1 0 0 ");
  Ways ways;
  for (const int lights : {0, 1}) {
    ways.emplace_back(lights > 0 ? "chosen" : "all", Compared("whitted", 256));
    ways.back().second.trace.lights = lights;
  }
  ExpectAllAlike(stage, ways);
}

TEST(Extremes, I5_StrategiesAgreeInsideEmissiveAbsorbingSolids) {
  const std::string inside =
      "camera 0 0 1.8  0 0 -1  0 1 0  0.5  0.01 100" + Material(0.5, 0, 0, 0) + no_light + "sphere 0 0 0 0 0.7 ";
  const std::string shining = Material(0, 0, 0, 1) + "absorb 1 0.5 0.7 0.9 ";
  for (const std::string lamp :
       {"box 1 -2 -2 -2  2 2 2 ", "begin -1  1.2 0 0 0  0 1 0 0  0 0 0.9 0  0 0 0 1 sphere 1 0 0 0  2.5 end ",
        "tri 1 -9 -1 -9  9 -1 -9  0 -1 9 "}) {
    SCOPED_TRACE(lamp);
    const project::Stage stage = StageOf(inside + shining + lamp);
    Ways ways;
    for (const char* strategy : {"bsdf", "mis", "light"}) {
      ways.emplace_back(strategy, Compared("path", 288));
      ways.back().second.trace.strategy = project::Named{strategy};
    }
    ExpectAllAlike(stage, ways);
  }
}

TEST(Extremes, I5_OneLightOrAFewStandForAll) {
  for (const char* mode : {"whitted", "path"}) {
    const project::Stage stage = StageOf(room + Lamps(true));
    Ways ways;
    for (const int lights : {0, 1, 3}) {
      ways.emplace_back(std::to_string(lights) + " lights in " + mode, Compared(mode, 32));
      ways.back().second.trace.lights = lights;
    }
    ExpectAllAlike(stage, ways);
  }
}

TEST(Extremes, I5_WhittedAndPathAgreeOnDirectLight) {
  // No mirrors, no bounces: both are the same integral over the sky and the lamps.
  std::string diffuse = room;
  const std::string glossy = Material(0.5, 0.3, 0, 0, 20);
  diffuse.replace(diffuse.find(glossy), glossy.size(), Material(0.5, 0, 0, 0));
  Ways ways;
  for (const char* mode : {"whitted", "path"}) {
    ways.emplace_back(mode, Compared(mode, 64));
    ways.back().second.trace.max_depth = 0;
  }
  ExpectAllAlike(StageOf(diffuse + Lamps(false), SunnySky()), ways);
}

TEST(Extremes, I5_EverySamplerGivesTheSameMean) {
  for (const char* mode : {"whitted", "path"}) {
    Ways ways;
    for (const char* sampler : ray::sampler_names) {
      if (std::string(sampler).ends_with("grid")) continue;  // their few places in a pixel are always the same
      ways.emplace_back(std::string(sampler) + " in " + mode, Compared(mode, 40));  // no square and no power of two
      ways.back().second.trace.sampler = project::Named{sampler};
      ways.back().second.trace.glossy = true;
      ways.back().second.camera = {.motion = {0.1, 0, 0}, .aperture = 0.05, .focus = 6};
    }
    ExpectAllAlike(StageOf(room + Lamps(true), SunnySky()), ways);
  }
}

TEST(Extremes, I7_RouletteCostsNoTruthAndPaysForItself) {
  // A hollow ball that keeps most of its light: without roulette every path is followed to the end.
  const project::Stage ball = StageOf("camera 0 0 1.9  0 0.3 -1  0 1 0  0.5  0.01 100" + Material(0.4, 0.1, 0, 0, 5) +
                                      "sphere 0 0 0 0 2 point_light 4 4 4  0 1 0  0 0 1");
  RenderSettings on = Compared("path", 32), off = on;
  on.trace.max_depth = off.trace.max_depth = 16;
  on.trace.roulette = ray::Roulette::on;
  off.trace.roulette = ray::Roulette::off;
  ExpectAllAlike(ball, {{"path, roulette", on}, {"none", off}});

  // What each ray is worth: variance times rays, in a room with many lamps.
  const project::Stage lamps = StageOf(room + Lamps(true));
  const auto cost = [&](RenderSettings settings) {
    settings.width = settings.height = 24;
    settings.trace.sampler = ray::SamplerKind::random;
    settings.samples = 16;
    const auto pictures = Pictures(lamps, settings, 8, 500);
    double variance = 0;
    for (int y = 0; y < settings.height; ++y)
      for (int x = 0; x < settings.width; ++x) {
        std::vector<double> values;
        for (const R2::Image& picture : pictures) values.push_back(Luminance(picture.At(x, y)));
        const double deviation = statistics::MeanOf(values).deviation;
        variance += deviation * deviation;
      }
    return variance * static_cast<double>(project::Render(lamps, settings).rays.Total());
  };
  std::printf("variance times rays: %g with roulette, %g without\n", cost(on), cost(off));
  EXPECT_LE(cost(on), cost(off));
}

TEST(Extremes, I7_TheCoursesModeMayFollowFaintMirrorsByChance) {
  // Mirrors that face each other, as in a dressing room.
  const std::string mirrors =
      "camera 0 0.1 0  0.1 0 -1  0 1 0  0.5  0.01 100" + Material(0.2, 0.6, 0, 0.1, 5) +
      "tri 0 -9 -9 -2  9 -9 -2  0 12 -2 tri 0 -9 -9 2  9 -9 2  0 12 2 point_light 1 1 1  0 1 0  0 0 1 "
      "background 0.5 0.5 0.5";
  RenderSettings exact = Compared("whitted", 8), by_chance = exact;
  exact.trace.max_depth = by_chance.trace.max_depth = 200;
  by_chance.trace.min_luminance = 0.3;
  by_chance.trace.roulette = ray::Roulette::on;
  const project::Stage stage = StageOf(mirrors);
  ExpectAllAlike(stage, {{"every ray", exact}, {"roulette", by_chance}});
  RenderSettings cut = by_chance;
  cut.trace.roulette = ray::Roulette::off;
  EXPECT_GT(std::abs(Compare(Pictures(stage, exact, few, 0), Pictures(stage, cut, few, 99)).whole), 4)
      << "cutting faint rays off loses light that this test should see";
  EXPECT_LT(project::Render(stage, by_chance).rays.Total(), project::Render(stage, exact).rays.Total());
}

TEST(Extremes, E6_LightsOfNoSizeGiveTheImagesOfPoints) {
  RenderSettings settings = Whitted(32, 2);
  const auto picture = [&](const std::string& light) { return project::Render(StageOf(room + light), settings).image; };
  // The order of roundings is that of a point light, so even the bits are.
  EXPECT_TRUE(picture("sphere_light 5 4 3  -1 3 1  0  0.1 0.2 0.3") ==
              picture("point_light 5 4 3  -1 3 1  0.1 0.2 0.3"));
  EXPECT_TRUE(picture("area_light 5 4 3  -1 3 1  0 -1 0  0  0.1 0.2 0.3") ==
              picture("spot_light 5 4 3  -1 3 1  0 -1 0  0.1 0.2 0.3  1.5707963267948966 1"));
  // And those of hardly any size give the same mean: where on them a sample goes still changes how much it brings.
  for (const std::string name : {"sphere_light 5 4 3  -1 3 1  ", "area_light 5 4 3  -1 3 1  0 -1 0  "}) {
    const auto pictures = [&](const std::string& size) {
      return Pictures(StageOf(room + name + size + "  0.1 0.2 0.3"), Compared("whitted", 64), few, 0);
    };
    ExpectSameMeans(pictures("0"), pictures("1e-7"), name);
  }
}

TEST(Extremes, E6_AFloorSeesNothingOfADiscEdgeOn) {
  const project::Stage stage = StageOf("camera 0 3 3  0 -1 -1  0 1 0  0.3  0.01 100" + Material(0.5, 0.3, 0, 0) +
                                       "box 0 -9 -1 -9  9 0 9 area_light 9 9 9  20 0 0  0 1 0  1  1 0 0");
  for (const char* mode : {"whitted", "path"}) {
    RenderSettings settings = Whitted(16, 16);
    settings.mode = project::Named{mode};
    const auto image = project::Render(stage, settings).image;
    for (const float channel : image.Channels()) EXPECT_EQ(channel, 0) << mode;
  }
}

}  // namespace
}  // namespace statistics
