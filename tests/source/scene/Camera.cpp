#include "source/scene/Camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

void ExpectFrame(const ray::Camera& c) {
  EXPECT_NEAR(Length(c.towards), 1, 1e-15);
  EXPECT_NEAR(Length(c.up), 1, 1e-15);
  EXPECT_NEAR(Length(c.right), 1, 1e-15);
  EXPECT_NEAR(Dot(c.towards, c.up), 0, 1e-15);
  EXPECT_NEAR(Dot(c.towards, c.right), 0, 1e-15);
  EXPECT_NEAR(Dot(Cross(c.right, c.up), -c.towards), 1, 1e-15);  // right-handed
}

TEST(Camera, TheEdgesOfTheImageAreXfovFromTheAxis) {
  ray::Camera c = ray::Aim({}, {0, 0, -2}, {0, 3, 0}).camera;
  c.xfov = 0.3;
  const auto angle = [&](double x, double y) {
    const R3::Vector d = c.Through(x, y, 200, 100).direction;
    return std::acos(Dot(Unit(d), c.towards));
  };
  EXPECT_NEAR(angle(0, 50), 0.3, 1e-12);
  EXPECT_NEAR(angle(200, 50), 0.3, 1e-12);
  EXPECT_NEAR(std::tan(angle(100, 100)), std::tan(0.3) / 2, 1e-12);  // yfov = atan(tan(xfov) height / width)
  EXPECT_LT(c.Through(0, 50, 200, 100).direction.x, 0);              // x from the left
  EXPECT_LT(c.Through(100, 0, 200, 100).direction.y, 0);             // y from the bottom
}

TEST(Camera, ItsOwnAspectIsKeptForAnyPixels) {
  ray::Camera c = ray::Aim({}, {0, 0, -1}, {0, 1, 0}).camera;
  c.xfov = std::atan(2);
  c.aspect = 4;
  for (const int height : {1, 100, 900}) {
    const R3::Vector d = c.Through(200, height, 200, height).direction;
    EXPECT_NEAR(d.x, 2, 1e-15);
    EXPECT_NEAR(d.y, 0.5, 1e-15);
  }
}

TEST(Camera, AShiftMovesTheWholeImageByHalfWidths) {
  ray::Camera c = ray::Aim({}, {0, 0, -1}, {0, 1, 0}).camera;
  c.xfov = std::atan(2);
  c.shift = {0.5, -1};
  const R3::Vector middle = c.Through(100, 50, 200, 100).direction, corner = c.Through(200, 100, 200, 100).direction;
  EXPECT_NEAR(middle.x, 1, 1e-15);
  EXPECT_NEAR(middle.y, -2, 1e-15);
  EXPECT_NEAR(corner.x, 3, 1e-15);
  EXPECT_NEAR(corner.y, -1, 1e-15);
}

TEST(Camera, StraightensUpThatIsNotPerpendicular) {
  const ray::AimedCamera aimed = ray::Aim({1, 2, 3}, {1, -2, 0.5}, {0.3, 1, -0.2});
  EXPECT_FALSE(aimed.up_was_replaced);
  ExpectFrame(aimed.camera);
  EXPECT_GT(Dot(aimed.camera.up, R3::Vector{0.3, 1, -0.2}), 0);
}

TEST(Extremes, G2_UpParallelToTheViewIsReplacedAndReported) {
  for (const R3::Vector towards : {R3::Vector{0, 1, 0}, R3::Vector{0, -1, 0}, R3::Vector{1e-11, -1, 0},
                                   R3::Vector{0.3, 0.4, 0.5}, R3::Vector{1, 0, 0}, R3::Vector{0, 0, 1e-200}}) {
    for (const double sign : {1.0, -1.0}) {
      const R3::Vector up = std::abs(towards.y) == 1 ? R3::Vector{0, sign, 0} : sign * towards;
      const ray::AimedCamera aimed = ray::Aim({}, towards, up);
      EXPECT_TRUE(aimed.up_was_replaced);
      ExpectFrame(aimed.camera);
    }
  }
}

TEST(Camera, TheDefaultOneSeesTheWholeScene) {
  R3::Box box;
  box.Extend(R3::Point{-1, -1, -1});
  box.Extend(R3::Point{1, 1, 1});
  const ray::Camera c = ray::DefaultCamera(box);
  EXPECT_DOUBLE_EQ(c.eye.z, 3 * std::sqrt(3.0));
  EXPECT_EQ(c.xfov, 0.25);
  EXPECT_EQ(ray::DefaultCamera({}).eye, (R3::Point{0, 0, 3}));
}

}  // namespace
