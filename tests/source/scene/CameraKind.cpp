#include "source/scene/CameraKind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "source/scene/CameraText.h"
#include "tests/Draw.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int width = 200, height = 120;

/// Returns the point where an image of width x height shows the target of a ray, by equations of each projection in
/// angles that share no code with the camera. `v` is right, up and towards.
using Inverse = std::array<double, 2> (*)(const std::array<double, 3>& v, double extent);
const std::map<std::string, Inverse> inverses{
    {"pinhole",
     [](const std::array<double, 3>& v, double extent) {
       const double half = std::tan(extent * pi / 360);
       return std::array{v[0] / v[2] / half, v[1] / v[2] / half};
     }},
    {"orthographic",
     [](const std::array<double, 3>& v, double extent) {
       return std::array{2 * v[0] / extent, 2 * v[1] / extent};
     }},
    {"fisheye",
     [](const std::array<double, 3>& v, double extent) {
       const double aside = std::hypot(v[0], v[1]), angle = std::atan2(aside, v[2]) * 360 / pi / extent;
       return aside == 0 ? std::array{0.0, 0.0} : std::array{angle * v[0] / aside, angle * v[1] / aside};
     }},
    {"cylinder",
     [](const std::array<double, 3>& v, double extent) {
       const double half = extent * pi / 360;
       return std::array{std::atan2(v[0], v[2]) / half, v[1] / std::hypot(v[0], v[2]) / half};
     }},
    {"latlong",
     [](const std::array<double, 3>& v, double) {
       return std::array{std::atan2(v[0], v[2]) / pi, std::atan2(v[1], std::hypot(v[0], v[2])) / pi};
     }},
};

/// Makes a camera of the kind at any position and direction.
Camera AnyCamera(const CameraKind& kind, Draw& draw) {
  Camera camera = Aim(R3::Point{} + draw.Direction(), draw.Direction(), draw.Direction()).camera;
  camera.kind = &kind;
  if (kind.extent == CameraExtent::angle) camera.extent = draw.Between(20, kind.is_panoramic ? 360 : 170);
  if (kind.extent == CameraExtent::width) camera.extent = draw.Between(0.1, 10);
  camera.xfov = kind.is_panoramic || kind.extent != CameraExtent::angle ? 0.4 : camera.extent * pi / 360;
  if (draw.Whole(0, 1)) camera.right = -camera.right;
  return camera;
}

TEST(CameraKind, EveryProjectionIsInvertedByItsEquations) {
  Draw draw(4100);
  for (const CameraKind* kind : CameraKinds()) {
    ASSERT_TRUE(inverses.contains(kind->name)) << kind->name << " needs its equations here";
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      const Camera camera = AnyCamera(*kind, draw);
      const double x = draw.Between(0, width), y = draw.Between(0, height);
      const auto ray = camera.RayThrough(x, y, width, height);
      if (!ray) continue;
      ++seen;
      const R3::Vector way = ray->At(draw.Between(0.5, 2)) - camera.eye;
      const auto place = inverses.at(kind->name)(
          {Dot(way, camera.right), Dot(way, camera.up), Dot(way, camera.towards)}, camera.Extent());
      EXPECT_NEAR(place[0], 2 * x / width - 1, 1e-9) << kind->name;
      const double aspect = kind->aspect > 0 ? kind->aspect : static_cast<double>(width) / height;
      EXPECT_NEAR(place[1], (2 * y / height - 1) / aspect, 1e-9) << kind->name;
    }
    EXPECT_GT(seen, 1000) << kind->name;
  }
}

TEST(CameraKind, APointOfARayIsSeenWhereTheRayIs) {
  Draw draw(4103);
  for (const CameraKind* kind : CameraKinds()) {
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      Camera camera = AnyCamera(*kind, draw);
      camera.shift = {draw.Between(-0.3, 0.3), draw.Between(-0.3, 0.3)};
      if (draw.Whole(0, 1)) camera.aspect = draw.Between(0.5, 2);
      const double x = draw.Between(0, width), y = draw.Between(0, height), t = draw.Between(0.5, 2);
      const auto ray = camera.RayThrough(x, y, width, height);
      if (!ray) continue;
      ++seen;
      const auto place = camera.PlaceOf(ray->At(t), width, height);
      ASSERT_TRUE(place) << kind->name << " " << x << " " << y;
      // A shifted panorama sees some directions twice.
      const auto same = camera.RayThrough(place->x, place->y, width, height);
      ASSERT_TRUE(same) << kind->name;
      EXPECT_LT(Length(same->origin - ray->origin), 1e-9 * camera.Extent()) << kind->name;
      EXPECT_LT(Length(Unit(same->direction) - Unit(ray->direction)), 1e-9) << kind->name;
      if (!kind->is_panoramic && kind->extent != CameraExtent::none) {
        EXPECT_NEAR(place->x, x, 1e-9 * width) << kind->name;
        EXPECT_NEAR(place->y, y, 1e-9 * width) << kind->name;
        EXPECT_FALSE(camera.PlaceOf(ray->At(-t), width, height)) << kind->name << ": it is behind the eye";
      }
    }
    EXPECT_GT(seen, 1000) << kind->name;
    EXPECT_FALSE(AnyCamera(*kind, draw).PlaceOf({NAN, 0, 0}, width, height)) << kind->name;
  }
}

TEST(CameraKind, AFisheyeSeesNothingOutsideOfItsCircle) {
  Draw draw(4101);
  const CameraKind& fisheye = *FindCameraKind("fisheye");
  for (int i = 0; i < 2000; ++i) {
    const Camera camera = AnyCamera(fisheye, draw);
    const double x = draw.Between(0, width), y = draw.Between(0, width);
    const bool is_inside = std::hypot(x - width / 2.0, y - width / 2.0) <= width / 2.0;
    EXPECT_EQ(camera.RayThrough(x, y, width, width).has_value(), is_inside) << x << " " << y;
  }
}

TEST(CameraKind, LensesArePerpendicularToTheirView) {
  Draw draw(4102);
  for (const CameraKind* kind : CameraKinds()) {
    if (!kind->sight || !kind->has_lens) continue;
    for (int i = 0; i < 500; ++i) {
      const Camera camera = AnyCamera(*kind, draw);
      const auto sight = camera.Sight(draw.Between(0, width), draw.Between(0, height), width, height);
      if (!sight) continue;
      EXPECT_NEAR(Length(sight->across), 1, 1e-14) << kind->name;
      EXPECT_NEAR(Length(sight->upward), 1, 1e-14) << kind->name;
      EXPECT_NEAR(Dot(sight->across, sight->upward), 0, 1e-14) << kind->name;
      EXPECT_NEAR(Dot(sight->across, sight->direction), 0, 1e-14) << kind->name;
    }
  }
}

TEST(CameraKind, AViewShiftsAndSqueezesEveryProjection) {
  for (const CameraKind* kind : CameraKinds()) {
    Camera camera;
    camera.kind = kind;
    camera.extent = kind->extent == CameraExtent::none || !kind->sight ? 0 : 100;
    camera.shift = {0.25, -0.125};
    camera.aspect = 2;
    // In half widths the center is at the shift, and the upper edge half a half width above it.
    Camera plain = camera;
    plain.shift = {0, 0};
    const auto moved = camera.RayThrough(100, 50, 200, 100), same = plain.RayThrough(125, 50 - 12.5, 200, 100);
    ASSERT_TRUE(moved && same) << kind->name;
    EXPECT_LT(Length(moved->direction - same->direction), 1e-14) << kind->name;
    EXPECT_LT(Length(moved->origin - same->origin), 1e-14) << kind->name;
  }
}

TEST(CameraKind, ItsLineReadsBackBitForBit) {
  Draw draw(4103);
  for (const CameraKind* kind : CameraKinds())
    for (int i = 0; i < 50; ++i) {
      Camera camera = AnyCamera(*kind, draw);
      if (draw.Whole(0, 1)) camera.shift = {draw.Between(-1, 1), draw.Between(-1, 1)};
      const bool has_width = kind->extent == CameraExtent::width;
      if (!kind->sight || (draw.Whole(0, 1) && !has_width)) camera.extent = 0;
      const std::string line = CameraLine(camera);
      const auto read = ReadCameraLine(line);
      ASSERT_TRUE(read) << line;
      const Camera of_scene = ParseText(line + "\n").scene.camera;
      for (const Camera& other : {*read, of_scene}) {
        EXPECT_EQ(CameraLine(other), line);
        EXPECT_EQ(other.kind, kind) << line;
        EXPECT_EQ(other.extent, camera.extent) << line;
        for (const double x : {30.0, 40.0, 70.0}) {
          const auto a = other.RayThrough(x, 50, 80, 100), b = camera.RayThrough(x, 50, 80, 100);
          ASSERT_EQ(a.has_value(), b.has_value()) << line;
          EXPECT_TRUE(!a || (a->direction == b->direction && a->origin == b->origin)) << line;
        }
      }
    }
  const std::string line = CameraLine(Camera());
  for (const char* bad : {" projection", " projection fish", " projection fisheye 361", " projection fisheye 90 2",
                          " projection latlong 3", " projection fisheye x"})
    EXPECT_FALSE(ReadCameraLine(line + bad)) << bad;
}

}  // namespace
}  // namespace ray
