#include "source/integrate/CameraRays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace ray {
namespace {

constexpr int image_width = 40, image_height = 30;
constexpr std::uint32_t samples = 64;

Camera Slanted() {
  Camera camera = Aim({1, 2, 3}, {-0.3, -0.4, -1}, {0.1, 1, 0}).camera;
  camera.xfov = 0.4;
  return camera;
}

CameraRays Make(const CameraEffects& effects, SamplerKind sampler = SamplerKind::sobol, std::uint32_t count = samples,
                bool things_move = false) {
  return {Slanted(), effects, things_move, image_width, image_height, sampler, count};
}

/// Returns the point where a ray crosses the plane at a distance along the axis from the camera at rest.
R3::Point OnPlane(const R3::Ray& ray, double distance) {
  const Camera camera = Slanted();
  const double t = (distance - Dot(ray.origin - camera.eye, camera.towards)) / Dot(ray.direction, camera.towards);
  return ray.At(t);
}

TEST(CameraRays, PointsInFocusAreSharpFromTheWholeLens) {
  for (const double focus : {0.5, 5.0, 1e3}) {
    const CameraRays rays = Make({.motion = {}, .aperture = 0.3, .focus = focus});
    for (int pixel = 0; pixel < image_width; pixel += 13)
      for (std::uint32_t i = 0; i < samples; ++i) {
        const CameraSample sample = rays({pixel, pixel / 2, RandomKey(3), i});
        // The pinhole's ray through the same place of the image.
        const R3::Point sharp = OnPlane(Slanted().Through(sample.x, sample.y, image_width, image_height), focus);
        EXPECT_LT(Length(OnPlane(sample.ray, focus) - sharp), 1e-12 * (focus + 5)) << focus;
        EXPECT_LE(Length(sample.ray.origin - Slanted().eye), 0.3 * (1 + 1e-12));
        EXPECT_NEAR(Dot(sample.ray.origin - Slanted().eye, Slanted().towards), 0, 1e-14);
      }
  }
}

TEST(CameraRays, PointsOutOfFocusBlurByTheThinLensEquation) {
  // A point at the distance d is spread over a circle of radius aperture |d - focus| / focus on the plane through it.
  const CameraRays rays = Make({.motion = {}, .aperture = 0.3, .focus = 4}, SamplerKind::sobol, 4096);
  for (const double distance : {2.0, 6.0, 12.0}) {
    double widest = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const CameraSample sample = rays({7, 9, RandomKey(3), i});
      const R3::Point middle = OnPlane(Slanted().Through(sample.x, sample.y, image_width, image_height), distance);
      widest = std::max(widest, Length(OnPlane(sample.ray, distance) - middle));
    }
    const double truth = 0.3 * std::abs(distance - 4) / 4;
    EXPECT_LE(widest, truth * (1 + 1e-12));
    EXPECT_GT(widest, truth * 0.99);
  }
}

TEST(CameraRays, AGridSamplesTheCentersOfEqualPixelParts) {
  for (const std::uint32_t side : {1u, 2u, 3u, 7u}) {
    const CameraRays rays = Make({}, SamplerKind::grid, side * side);
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const CameraSample sample = rays({7, 9, RandomKey(3), i});
      EXPECT_EQ(sample.x, 7 + (i % side + 0.5) / side);
      EXPECT_EQ(sample.y, 9 + (i / side + 0.5) / side);
    }
  }
}

// Still a square grid: each place is another one rotated by a quarter turn about the middle.
TEST(CameraRays, ARotatedGridNeverRepeatsARowOrColumn) {
  for (const std::uint32_t side : {1u, 2u, 3u, 7u}) {
    const CameraRays rays = Make({}, SamplerKind::rotated_grid, side * side);
    std::set<std::int64_t> columns, rows;
    std::set<std::pair<std::int64_t, std::int64_t>> places, turned;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const CameraSample sample = rays({7, 9, RandomKey(3), i});
      // In units of half a part, from the middle.
      const double x = 2 * side * side * (sample.x - 7.5), y = 2 * side * side * (sample.y - 9.5);
      EXPECT_NEAR(x, std::round(x), 1e-9);
      EXPECT_LT(std::max(std::abs(x), std::abs(y)), side * side);
      columns.insert(std::llround(x));
      rows.insert(std::llround(y));
      places.insert({std::llround(x), std::llround(y)});
      turned.insert({-std::llround(y), std::llround(x)});
    }
    EXPECT_EQ(columns.size(), side * side);
    EXPECT_EQ(rows.size(), side * side);
    EXPECT_EQ(places, turned);
  }
}

TEST(CameraRays, EveryGridAndLensSampleGetsEvenShutterTimes) {
  constexpr std::uint32_t places = 4, on_lens = 3, moments = 5;
  CameraEffects effects{.motion = {1, 0, 0}, .aperture = 2, .focus = 4, .lens = LensPattern::fixed_spiral};
  effects.lens_samples = on_lens;
  effects.shutter_samples = moments;
  const CameraRays rays = Make(effects, SamplerKind::grid, places * on_lens * moments);
  std::set<std::tuple<double, double, double, double>> all;
  std::map<double, int> times;
  for (std::uint32_t i = 0; i < places * on_lens * moments; ++i) {
    const CameraSample sample = rays({7, 9, RandomKey(3), i});
    const R3::Vector on_the_lens = sample.ray.origin - Slanted().eye - sample.ray.time * effects.motion;
    all.insert({sample.x, sample.y, sample.ray.time, std::round(1e6 * Dot(on_the_lens, Slanted().right))});
    ++times[sample.ray.time];
  }
  EXPECT_EQ(all.size(), places * on_lens * moments) << "each goes with each";
  for (const double time : {0.1, 0.3, 0.5, 0.7, 0.9}) EXPECT_EQ(times[time], places * on_lens) << time;
}

TEST(CameraRays, TheFixedSpiralRestartsForEveryGridSample) {
  constexpr std::uint32_t places = 4, each = 16;
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  const CameraRays rays =
      Make({.motion = {}, .aperture = 2, .focus = 4, .lens = LensPattern::fixed_spiral, .lens_samples = each},
           SamplerKind::grid, places * each);
  for (std::uint32_t i = 0; i < places * each; ++i) {
    const CameraSample sample = rays({7, 9, RandomKey(3), i});
    const std::uint32_t place = i / each, n = i % each;
    EXPECT_EQ(sample.x, 7 + (place % 2 + 0.5) / 2);
    EXPECT_EQ(sample.y, 9 + (place / 2 + 0.5) / 2);
    const R3::Vector aside = sample.ray.origin - Slanted().eye;
    EXPECT_NEAR(Length(aside), 2 * std::sqrt(n / 16.0), 1e-12);
    EXPECT_NEAR(Dot(aside, Slanted().right), 2 * std::sqrt(n / 16.0) * std::cos(n * golden_angle), 1e-12);
  }
}

TEST(CameraRays, TurnedSpiralsStayOnTheLensAndDifferBetweenPixels) {
  const CameraEffects spiral{.motion = {}, .aperture = 2, .focus = 4, .lens = LensPattern::spiral, .lens_samples = 8};
  const CameraRays rays = Make(spiral, SamplerKind::grid, 8);
  std::set<double> across;
  for (int column = 0; column < image_width; ++column)
    for (std::uint32_t i = 0; i < 8; ++i) {
      const R3::Vector aside = rays({column, 9, RandomKey(3), i}).ray.origin - Slanted().eye;
      EXPECT_LE(Length(aside), 2 * (1 + 1e-12));
      across.insert(Dot(aside, Slanted().right));
    }
  EXPECT_EQ(across.size(), static_cast<std::size_t>(8 * image_width));
}

TEST(CameraRays, LensSamplesFillTheLensEvenly) {
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::random, SamplerKind::stratified}) {
    constexpr std::uint32_t many = 4096;
    const CameraRays rays = Make({.motion = {}, .aperture = 2, .focus = 4}, sampler, many);
    int within_half_radius = 0, right = 0;
    for (std::uint32_t i = 0; i < many; ++i) {
      const R3::Vector aside = rays({7, 9, RandomKey(3), i}).ray.origin - Slanted().eye;
      within_half_radius += Length(aside) <= 1;
      right += Dot(aside, Slanted().right) > 0;
    }
    const double deviation = std::sqrt(0.25 / many);
    EXPECT_NEAR(within_half_radius / double(many), 0.25, 4 * deviation);
    EXPECT_NEAR(right / double(many), 0.5, 4 * deviation);
  }
}

TEST(CameraRays, BatchesEqualSingleRays) {
  // An image must not depend on which samples happen to be in a batch.
  CameraEffects lens{.motion = {}, .aperture = 0.3, .focus = 4}, spiral = lens, moving = lens;
  spiral.lens = LensPattern::spiral, spiral.lens_samples = 4;
  moving.motion = {1, 0, 2};
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::stratified, SamplerKind::grid})
    for (const CameraEffects& effects : {CameraEffects{}, lens, spiral, moving, CameraEffects{.motion = {0, 1, 0}}})
      for (const std::uint32_t count : {1u, samples}) {
        const CameraRays rays = Make(effects, sampler, count);
        std::vector<PixelSample> due;
        for (std::uint32_t i = 0; i < R1::batch_size - 3; ++i)
          due.push_back({static_cast<int>(i / 7), static_cast<int>(i / 30), RandomKey(i / 7), i % count});
        std::vector<CameraSample> together(due.size());
        rays.MakeEach(due, together);
        for (std::size_t i = 0; i < due.size(); ++i) {
          const CameraSample alone = rays(due[i]);
          ASSERT_EQ(together[i].ray.origin, alone.ray.origin) << rays.Kernel() << " " << i;
          ASSERT_EQ(together[i].ray.direction, alone.ray.direction) << rays.Kernel() << " " << i;
          ASSERT_EQ(together[i].ray.time, alone.ray.time);
          ASSERT_EQ(together[i].x, alone.x);
          ASSERT_EQ(together[i].y, alone.y);
          ASSERT_EQ(together[i].index.key.Bits(), alone.index.key.Bits());
          ASSERT_EQ(together[i].index.sample, due[i].index);
          ASSERT_EQ(together[i].index.camera_dimensions, alone.index.camera_dimensions);
        }
      }
}

// Settings without an effect must not change a bit of the image.
TEST(CameraRays, ZeroApertureAndMotionEqualThePinholeExactly) {
  const CameraRays pinhole = Make({}), none = Make({.motion = {0, 0, 0}, .aperture = 0, .focus = 7});
  EXPECT_EQ(none.Kernel(), "pinhole");
  for (std::uint32_t i = 0; i < samples; ++i) {
    const CameraSample a = pinhole({5, 6, RandomKey(1), i}), b = none({5, 6, RandomKey(1), i});
    EXPECT_EQ(a.ray.origin, b.ray.origin);
    EXPECT_EQ(a.ray.direction, b.ray.direction);
    EXPECT_EQ(a.ray.time, b.ray.time);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.index.key.Bits(), b.index.key.Bits());
  }
}

TEST(CameraRays, KernelsAreNamedAfterWhatTheyDo) {
  const CameraEffects lens{.motion = {}, .aperture = 1, .focus = 1},
      motion{.motion = {1, 0, 0}, .aperture = 0, .focus = 0};
  CameraEffects both = lens;
  both.motion = motion.motion;
  EXPECT_EQ(Make({}).Kernel(), "pinhole");
  EXPECT_EQ(Make(lens).Kernel(), "lens");
  EXPECT_EQ(Make(motion).Kernel(), "moving pinhole");
  EXPECT_EQ(Make(both).Kernel(), "moving lens");
  EXPECT_EQ(Make({}, SamplerKind::sobol, 4, true).Kernel(), "moving pinhole");
}

/// The cameras other than pinholes, in the view of the pinhole.
std::vector<Camera> Projections() {
  std::vector<Camera> cameras;
  for (const CameraKind* kind : CameraKinds()) {
    if (!kind->sight) continue;
    cameras.push_back(Slanted());
    cameras.back().kind = kind;
    cameras.back().extent = kind->extent == CameraExtent::none ? 0 : 200;
  }
  return cameras;
}

TEST(CameraRays, InFocusEveryProjectionWithALensIsSharp) {
  for (const Camera& camera : Projections()) {
    if (!camera.kind->has_lens) continue;
    const double focus = 3;
    const CameraRays rays(camera, {.motion = {}, .aperture = 0.3, .focus = focus}, false, image_width, image_height,
                          SamplerKind::sobol, samples);
    double widest = 0;
    for (int pixel = 5; pixel < image_width - 5; pixel += 7)
      for (std::uint32_t i = 0; i < samples; ++i) {
        const CameraSample sample = rays({pixel, 15, RandomKey(3), i});
        const auto middle = camera.Sight(sample.x, sample.y, image_width, image_height);
        ASSERT_TRUE(middle && sample.HasRay()) << camera.kind->name;
        EXPECT_LT(Length(sample.ray.At(focus) - (middle->origin + focus * middle->direction)), 1e-12)
            << camera.kind->name;
        const double aside = Length(sample.ray.origin - middle->origin);
        EXPECT_LE(aside, 0.3 * (1 + 1e-12)) << camera.kind->name;
        widest = std::max(widest, aside);
      }
    EXPECT_GT(widest, 0.28) << camera.kind->name;
  }
}

TEST(CameraRays, EveryProjectionMovesAndKeepsItsView) {
  const R3::Vector motion{0.5, -0.25, 2};
  for (const Camera& camera : Projections()) {
    const CameraRays rays(camera, {.motion = motion}, false, image_width, image_height, SamplerKind::sobol, samples);
    EXPECT_EQ(rays.Kernel(), std::string("moving ") + camera.kind->name);
    for (std::uint32_t i = 0; i < samples; ++i) {
      const CameraSample sample = rays({12, 16, RandomKey(1), i});
      const auto rest = camera.RayThrough(sample.x, sample.y, image_width, image_height);
      ASSERT_TRUE(rest) << camera.kind->name;
      EXPECT_EQ(sample.ray.direction, rest->direction);
      EXPECT_LT(Length(sample.ray.origin - (rest->origin + sample.ray.time * motion)), 1e-14);
    }
  }
}

TEST(CameraRays, OutsideOfAProjectionsViewThereIsNoRay) {
  for (Camera camera : Projections()) {
    camera.shift = {0.3, 0.3};
    for (const CameraEffects& effects :
         {CameraEffects(), CameraEffects{.motion = {1, 0, 0}, .aperture = 1, .focus = 2}}) {
      const CameraRays rays(camera, effects, false, image_width, image_width, SamplerKind::sobol, samples);
      for (int pixel = 0; pixel < image_width; ++pixel)
        for (std::uint32_t i = 0; i < samples; ++i) {
          const CameraSample sample = rays({pixel, pixel, RandomKey(3), i});
          EXPECT_EQ(sample.HasRay(), camera.Sight(sample.x, sample.y, image_width, image_width).has_value());
        }
    }
  }
}

TEST(CameraRays, TheEyeMovesEvenlyWhileTheShutterIsOpen) {
  const R3::Vector motion{0.5, -0.25, 2};
  const CameraRays rays = Make({.motion = motion}), at_rest = Make({}, SamplerKind::sobol, samples, true);
  std::vector<double> times;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const CameraSample sample = rays({5, 6, RandomKey(1), i});
    times.push_back(sample.ray.time);
    EXPECT_GE(sample.ray.time, 0);
    EXPECT_LT(sample.ray.time, 1);
    EXPECT_LT(Length(sample.ray.origin - (Slanted().eye + sample.ray.time * motion)), 1e-14);
    // The view does not turn: the direction is that of the camera at rest at the same time.
    const CameraSample rest = at_rest({5, 6, RandomKey(1), i});
    EXPECT_EQ(sample.ray.direction, rest.ray.direction);
    EXPECT_EQ(sample.ray.time, rest.ray.time);
    EXPECT_EQ(rest.ray.origin, Slanted().eye);
  }
  // 64 points of a Sobol' sequence: one in each 64th of the time.
  std::sort(times.begin(), times.end());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(times[i] * samples), i);
}

TEST(CameraRays, OneSampleIsCenteredAndManyFillThePixel) {
  const CameraSample middle = Make({}, SamplerKind::sobol, 1)({5, 6, RandomKey(1), 0});
  EXPECT_EQ(middle.x, 5.5);
  EXPECT_EQ(middle.y, 6.5);
  const CameraSample with_lens =
      Make({.motion = {}, .aperture = 1, .focus = 2}, SamplerKind::sobol, 1)({5, 6, RandomKey(1), 0});
  EXPECT_EQ(with_lens.x, 5.5);
  EXPECT_EQ(with_lens.y, 6.5);
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::random, SamplerKind::stratified}) {
    const CameraRays rays = Make({}, sampler);
    double x = 0, y = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const CameraSample sample = rays({5, 6, RandomKey(1), i});
      EXPECT_TRUE(sample.x >= 5 && sample.x < 6 && sample.y >= 6 && sample.y < 7);
      x += sample.x / samples, y += sample.y / samples;
    }
    EXPECT_NEAR(x, 5.5, 4 * std::sqrt(1.0 / 12 / samples));
    EXPECT_NEAR(y, 6.5, 4 * std::sqrt(1.0 / 12 / samples));
  }
}

}  // namespace
}  // namespace ray
