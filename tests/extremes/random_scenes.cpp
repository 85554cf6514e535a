// Scenes of everything that the language has, at random: what rays hit, by every structure and in 113 bits, and the
// light in their pictures. RAYTESTS_SCENES tells how many, RAYTESTS_SEED which is the first, RAYTESTS_STEP how far it
// is to the next: seeds 2, 5, 8... make scenes whose surfaces touch. make fuzz-scenes tries 100,000. A scene that fails
// is kept, with what it names beside it, and named.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "source/integrate/CameraRays.h"
#include "source/integrate/Path.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/integrate/lights/EmissiveShape.h"
#include "source/integrate/lights/EmissiveTriangle.h"
#include "source/render/RenderBlock.h"
#include "tests/Accelerators.h"
#include "tests/ExactScene.h"
#include "tests/Project.h"
#include "tests/RandomScene.h"
#include "tests/Statistics.h"
#include "tests/source/app/Program.h"

namespace {

namespace fs = std::filesystem;
using ray::RenderSettings;
using ray::testing::TemporaryFolder;

project::Stage StageIn(const TemporaryFolder& folder, const RandomScene& scene) {
  for (const auto& [name, bytes] : scene.files) ray::testing::WriteFile(folder / name, bytes);
  return project::Stage(fs::path(ray::testing::WriteFile(folder / "scene.scn", scene.text)));
}

/// Runs a check on each scene; of the first that fails all is kept.
template <typename Check>
void ForEachScene(int unless_set, const RandomScene::Light& light, const Check& check) {
  const auto first = static_cast<std::uint64_t>(ray::testing::Rounds("RAYTESTS_SEED", 1));
  const int count = ray::testing::Rounds("RAYTESTS_SCENES", unless_set);
  const auto step = static_cast<std::uint64_t>(ray::testing::Rounds("RAYTESTS_STEP", 1));
  for (std::uint64_t seed = first; seed < first + step * static_cast<std::uint64_t>(count); seed += step) {
    const TemporaryFolder folder;
    const project::Stage stage = StageIn(folder, RandomScene(seed, light));
    check(stage, seed);
    if (!testing::Test::HasFailure()) continue;
    const fs::path kept = fs::temp_directory_path() / ("raytests-scene-" + std::to_string(seed));
    fs::copy(folder.Path(), kept, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    FAIL() << "the scene of seed " << seed << " is kept as " << kept / "scene.scn";
  }
  std::printf("%d scenes, seeds from %llu by %llu\n", count, static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(step));
}

TEST(RandomScenes, AreHitAsEveryStructureAndArithmeticOf113BitsSay) {
  const auto ways = accelerators::EveryWay();
  ForEachScene(60, {}, [&](const project::Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    auto rays = accelerators::RaysAt(stage.world, draw, 20);
    for (R3::Ray& ray : rays) ray.time = draw.Between(0, 1);
    accelerators::Compare(stage.world, rays, ways);
    const oracle::Scene exact(stage.world);
    const auto none = ray::FindAcceleratorKind("none")->Make(stage.world, {});
    ray::Workspace workspace;
    for (const R3::Ray& ray : rays)
      EXPECT_EQ(exact.WhatIsWrong(ray, none->Intersect(ray, workspace)), "") << oracle::Hex(ray) << ' ' << ray.time;
  });
}

template <typename Enumerator, typename Names>
Enumerator OneOf(Draw& draw, const Names& names) {
  return static_cast<Enumerator>(draw.Whole(0, static_cast<int>(std::size(names)) - 1));
}

RenderSettings RandomSettings(Draw& draw) {
  RenderSettings s;
  s.width = draw.Whole(1, 14);
  s.height = draw.Whole(1, 12);
  s.samples = draw.Whole(1, 3);
  s.seed = static_cast<std::uint64_t>(draw.Whole(0, 1000));
  const int mode = draw.Whole(0, 5);
  s.mode = mode < 2   ? ray::RenderMode::whitted
           : mode < 4 ? ray::RenderMode::path
                      : OneOf<ray::RenderMode>(draw, ray::render_modes);
  s.filter = OneOf<ray::FilterKind>(draw, ray::filter_names);
  if (draw.Whole(0, 3) == 0) s.camera.motion = draw.Direction();
  if (draw.Whole(0, 3) == 0) s.camera.aperture = draw.Between(0, 0.5), s.camera.focus = draw.Scale(-1, 1);
  s.trace.max_depth = draw.Whole(0, 5);
  s.trace.min_luminance = draw.Whole(0, 1) ? 0.01 : 0;
  s.trace.shadow_samples = draw.Whole(1, 3);
  s.trace.shadows = draw.Whole(0, 3) > 0;
  s.trace.glossy = draw.Whole(0, 1);
  s.trace.fresnel = draw.Whole(0, 1);
  s.trace.emissive_solids_light = draw.Whole(0, 1);
  s.trace.lights = draw.Whole(-1, 2);
  s.trace.roulette = OneOf<ray::Roulette>(draw, ray::roulette_names);
  s.trace.strategy = OneOf<ray::LightStrategy>(draw, ray::strategy_names);
  s.trace.sampler = OneOf<ray::SamplerKind>(draw, ray::sampler_names);
  s.trace.emission = OneOf<ray::Emission>(draw, ray::emission_names);
  s.trace.emissive_meshes = OneOf<ray::EmissiveMeshes>(draw, ray::emissive_mesh_names);
  return s;
}

bool IsOfLight(const RenderSettings& s) {
  return s.mode == ray::RenderMode::whitted || s.mode == ray::RenderMode::path;
}
/// Whether a pixel is a mean of samples, none of which counts against the others.
bool IsMean(const RenderSettings& s) {
  return s.filter == ray::FilterKind::box || s.filter == ray::FilterKind::gaussian;
}

/// The most that reaches a point from a light, by its falloff at distance 0 or, for an even disc or ball, at any.
R2::Color MostOf(const ray::Light& light) {
  const R3::Recipe recipe = light.MadeFrom();
  const auto& arguments = ray::FindLightKind(recipe.kind)->arguments;
  const auto& a = recipe.arguments;
  double constant = 1;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (arguments[i].name == std::string("ca")) constant = a[i];
  return R2::Color{a[0], a[1], a[2]} / constant;
}

R2::Color Largest(const R2::Color& a, const R2::Color& b) {
  return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)};
}

/// What no pixel of mode whitted exceeds: at each surface all lights at their strongest and straight above, then the
/// same again, times the weights of the two rays that go on.
R2::Color MostOfWhitted(const ray::World& world, const RenderSettings& s) {
  const ray::Scene& scene = world.scene();
  R2::Color lights, direct, onward;
  for (const auto& light : scene.lights) lights += MostOf(*light);
  for (const auto& triangle : ray::EmissiveTriangles(world)) lights += triangle.emission;
  if (s.trace.emissive_solids_light)
    for (const auto& shape : ray::EmissiveShapes(world)) lights += shape.Emission();
  for (const ray::Material& m : scene.materials) {
    direct = Largest(direct, m.emission + m.ka * scene.ambient + (m.kd + m.ks) * lights);
    onward = Largest(onward, m.kr + m.kt + (m.coat > 0 ? R2::Color{1, 1, 1} : R2::Color{}));
  }
  R2::Color most = Largest(direct, scene.background);
  for (std::int64_t depth = 0; depth < s.trace.max_depth; ++depth)
    most = Largest(scene.background, direct + onward * most);
  return most;
}

/// Sums of as many roundings as a picture of this size has, each of a single precision at most.
constexpr double rounding = 1e-5;

void CheckLight(const R2::Image& image, const R2::Color& most, const std::string& what) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = image.At(x, y);
      EXPECT_TRUE(c.r >= 0 && c.g >= 0 && c.b >= 0) << what << ": negative at " << x << ' ' << y;
      EXPECT_TRUE(c.r <= (1 + rounding) * most.r && c.g <= (1 + rounding) * most.g && c.b <= (1 + rounding) * most.b)
          << what << ": " << c.r << ' ' << c.g << ' ' << c.b << " of at most " << most.r << ' ' << most.g << ' '
          << most.b << " at " << x << ' ' << y;
    }
}

TEST(RandomScenes, GiveOneFiniteImageThatGainsNoLight) {
  ForEachScene(150, {}, [&](const project::Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    RenderSettings s = RandomSettings(draw);
    s.threads = 1;
    const std::string mode = NamesOf(s.mode)[static_cast<std::size_t>(s.mode)];
    const R2::Image expected = project::Render(stage, s, {"none"}).image;
    for (const float channel : expected.Channels()) EXPECT_TRUE(std::isfinite(channel)) << mode;
    for (const char* kind : {"graph", "grid", "octree", "bvh"}) {
      if (ray::ShowsCosts(s.mode)) break;  // which are the structure's own
      EXPECT_TRUE(project::Render(stage, s, {kind}).image == expected) << mode << " by " << kind;
    }
    s.threads = draw.Whole(2, 5);
    s.tile_size = draw.Whole(0, 1) ? 8 : 0;
    EXPECT_TRUE(project::Render(stage, s, {"none"}).image == expected) << mode << " on " << s.threads << " threads";
    if (!IsOfLight(s)) return;
    const R2::Color any{R3::infinity, R3::infinity, R3::infinity};
    // Where lights are chosen, or paths survive, by chance, single samples have no bound.
    const bool is_bounded = s.mode == ray::RenderMode::whitted && s.trace.lights <= 0 &&
                            s.trace.roulette != ray::Roulette::on && !stage.scene->environment;
    if (IsMean(s)) CheckLight(expected, is_bounded ? MostOfWhitted(stage.world, s) : any, mode);
    // All of it is in proportion to the lights: to the bit, since a factor of 2 is exact but of the least of floats.
    const TemporaryFolder folder;
    const project::Stage brighter = StageIn(folder, RandomScene(seed, {.brightness = 2}));
    const R2::Image twice = project::Render(brighter, s, {"bvh"}).image;
    const auto is_twice = [](float a, float b) {
      return a == 2 * b || std::abs(a) < 4 * std::numeric_limits<float>::min();
    };
    EXPECT_TRUE(std::ranges::equal(twice.Channels(), expected.Channels(), is_twice)) << mode;
  });
}

TEST(RandomScenes, NothingIsBrighterThanTheSkyThatLightsIt) {
  ForEachScene(150, {.is_furnace = true}, [&](const project::Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    RenderSettings s = RandomSettings(draw);
    s.mode = ray::RenderMode::path;
    if (!IsMean(s)) s.filter = ray::FilterKind::gaussian;
    s.trace.max_depth = draw.Whole(0, 1000);
    CheckLight(project::Render(stage, s, {"bvh"}).image, {1, 1, 1}, "path");
  });
}

/// How far the mean of pictures is off that of other ones, in standard deviations of the difference. Where that is in
/// doubt, more samples tell what lights rarely from what never does.
double Disagreement(const project::Stage& stage, RenderSettings one, RenderSettings other, double doubtful) {
  constexpr int pictures = 12, rounds = 4;
  double deviations = 0;
  for (int round = 0; round < rounds; ++round, one.samples *= 8, other.samples *= 8) {
    const auto seed = static_cast<std::uint64_t>(1000 * round);
    const auto c = statistics::Compare(statistics::Pictures(stage, one, pictures, seed),
                                       statistics::Pictures(stage, other, pictures, seed + 500));
    deviations = std::abs(c.whole);
    if (!(deviations > doubtful)) break;
  }
  return deviations;
}

TEST(RandomScenes, HaveOneMeanHoweverLightIsFound) {
  ForEachScene(10, {}, [&](const project::Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    RenderSettings s = RandomSettings(draw);
    s.mode = ray::RenderMode::path;
    s.threads = 1;
    s.width = s.height = 6;
    s.samples = 16;
    s.filter = ray::FilterKind::box;
    s.trace.sampler = ray::SamplerKind::random;
    s.trace.max_depth = draw.Whole(1, 3);
    s.trace.shadows = true;  // without, lamps that are hidden shine where they are sampled and are not found elsewhere
    s.trace.strategy = ray::LightStrategy::bsdf;
    s.trace.lights = 0;
    for (const auto strategy : {ray::LightStrategy::mis, ray::LightStrategy::light})
      for (const int lights : {0, 1}) {
        RenderSettings way = s;
        way.trace.strategy = strategy;
        way.trace.lights = lights;
        way.trace.roulette = lights > 0 ? ray::Roulette::on : ray::Roulette::off;
        constexpr double doubtful = 6;
        EXPECT_LE(Disagreement(stage, s, way, doubtful), doubtful)
            << "strategy " << static_cast<int>(strategy) << ", lights " << lights;
      }
  });
}

std::vector<ray::CameraSample> SamplesOf(const project::Stage& stage, const RenderSettings& s) {
  const auto count = static_cast<std::uint32_t>(s.samples);
  const ray::CameraRays camera(stage.scene->camera, s.camera, true, s.width, s.height, s.trace.sampler, count);
  std::vector<ray::CameraSample> samples;
  for (int row = 0; row < s.height; ++row)
    for (int column = 0; column < s.width; ++column)
      for (std::uint32_t i = 0; i < count; ++i)
        samples.push_back(camera({column, row, ray::PixelKey(ray::RandomKey(s.seed), column, row, 0), i}));
  return samples;
}

TEST(RandomScenes, PathsTakenTogetherEqualThoseTakenAlone) {
  ForEachScene(1500, {}, [&](const project::Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    RenderSettings s = RandomSettings(draw);
    s.trace.samples = static_cast<std::uint32_t>(s.samples);
    const auto accelerator = ray::FindAcceleratorKind("bvh")->Make(stage.world, {});
    const ray::Path path(stage.world, *accelerator, s.trace);
    const auto samples = SamplesOf(stage, s);
    std::vector<R2::Color> alone(samples.size()), together(samples.size());
    ray::TraceState of_one, of_all;
    path.Li(samples, together, of_all);
    ray::RayRecorder recorder;  // with which surfaces are made one by one, too
    of_one.recorder = &recorder;
    path.Li(samples, alone, of_one);
    EXPECT_TRUE(together == alone);
    EXPECT_EQ(of_all.rays.throughput_cut, of_one.rays.throughput_cut);
    EXPECT_EQ(of_all.rays.caustics, of_one.rays.caustics);
    for (std::size_t kind = 0; kind < of_one.rays.kinds.size(); ++kind)
      EXPECT_EQ(of_all.rays.kinds[kind].rays, of_one.rays.kinds[kind].rays) << "kind " << kind;
  });
}

}  // namespace
