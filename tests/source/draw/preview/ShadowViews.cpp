#include "source/draw/preview/ShadowViews.h"

#include <gtest/gtest.h>

#include <cmath>

#include "R3/Warp.h"
#include "tests/Draw.h"

namespace {

std::array<double, 4> Clip(const ray::ClipMatrix& m, const R3::Vector& p) {
  std::array<double, 4> clip{};
  for (std::size_t r = 0; r < 4; ++r) clip[r] = m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r];
  return clip;
}

bool Sees(const ray::ClipMatrix& m, const R3::Vector& p) {
  const auto clip = Clip(m, p);
  return clip[3] > 0 && std::abs(clip[0]) <= clip[3] && std::abs(clip[1]) <= clip[3] && std::abs(clip[2]) <= clip[3];
}

ray::PreviewLight At(float x, float y, float z) {
  ray::PreviewLight light;
  light.place = {x, y, z};
  return light;
}

TEST(ShadowViews, SeeTheWholeSceneExceptInsideTheLight) {
  Draw draw(17);
  ray::PreviewLight sun = At(0.6F, 0, 0.8F), lamp = At(0.2F, 0.3F, -0.1F);
  sun.is_infinite = true;
  lamp.radius = 0.1;
  for (const ray::PreviewLight& light : {sun, lamp, At(0.9F, 0, 0), At(2, 0, 0), At(100, 50, -20)}) {
    const auto found = ray::ShadowViewsOf({light});
    const std::size_t expected = found.first.at(0) > 0 ? 1 : 6;
    ASSERT_EQ(found.clip_from_drawing.size(), expected);
    for (int i = 0; i < 1000; ++i) {
      const R3::Vector p = draw.Between(0, 1) * R3::SampleUniformSphere({draw.Between(0, 1), draw.Between(0, 1)});
      const R3::Vector place{light.place[0], light.place[1], light.place[2]};
      if (!light.is_infinite && Length(p - place) < 2 * light.radius + 0.01) continue;
      int views = 0;
      for (const ray::ClipMatrix& view : found.clip_from_drawing) views += Sees(view, p);
      EXPECT_GE(views, 1) << light.place[0] << ' ' << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(ShadowViews, OfFlatLampsSeeWhatIsCloseFromAllPlaces) {
  ray::PreviewLight lamp = At(0, 0.9F, 0);
  lamp.radius = 0.3;
  lamp.is_flat = true;
  lamp.direction = {0, -1, 0};
  const auto found = ray::ShadowViewsOf({lamp});
  ASSERT_EQ(found.clip_from_drawing.size(), static_cast<std::size_t>(ray::places_of_light));
  EXPECT_EQ(found.places.at(0), ray::places_of_light);
  for (const ray::ClipMatrix& view : found.clip_from_drawing) {
    EXPECT_TRUE(Sees(view, {0, 0.8, 0})) << "nearer than the lamp is wide";
    EXPECT_TRUE(Sees(view, {0.3, -0.8, 0.3}));
    EXPECT_FALSE(Sees(view, {0, 0.95, 0})) << "behind it";
  }
}

TEST(ShadowViews, OfANarrowSpotSeeItsConeAlone) {
  ray::PreviewLight spot = At(0, 0, -0.5F);
  spot.least_cosine = std::cos(0.3);
  const auto found = ray::ShadowViewsOf({spot});
  ASSERT_EQ(found.clip_from_drawing.size(), 1u);
  EXPECT_TRUE(Sees(found.clip_from_drawing[0], {std::tan(0.29) * 0.7, 0, 0.2}));
  EXPECT_FALSE(Sees(found.clip_from_drawing[0], {std::tan(0.4) * 0.7, 0, 0.2}));
}

TEST(ShadowViews, AreOfTheFirstLightsThatHaveRoom) {
  std::vector<ray::PreviewLight> lights(5, At(0, 0, 0));
  lights[1].casts_shadows = false;
  lights.push_back(At(3, 0, 0));
  const auto found = ray::ShadowViewsOf(lights);
  EXPECT_EQ(found.first, (std::vector<int>{-1, 0, -7, -13, -19, 0}));
  EXPECT_EQ(found.clip_from_drawing.size(), ray::most_shadow_views);
}

}  // namespace
