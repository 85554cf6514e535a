#include "source/draw/CameraMoves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "source/scene/CameraText.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr DrawingSize size{640, 480};

class CameraMoves : public testing::Test {
 protected:
  double Number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  R3::Vector Vector(double reach) { return {Number(-reach, reach), Number(-reach, reach), Number(-reach, reach)}; }
  Camera AnyCamera() {
    Camera camera = Aim(R3::Point{} + Vector(10), Vector(1), Vector(1)).camera;
    camera.xfov = Number(0.1, 1);
    return camera;
  }
  /// A camera whose image has its own aspect and is not centered on the axis.
  Camera AnyShiftedCamera() {
    Camera camera = AnyCamera();
    camera.aspect = Number(0.5, 3);
    camera.shift = {Number(-2, 2), Number(-2, 2)};
    return camera;
  }
  R3::Point InFrontOf(const Camera& camera) {
    const double depth = Number(1, 20), reach = 0.7 * depth * std::tan(camera.xfov);
    return camera.eye + depth * camera.towards + Number(-reach, reach) * camera.right +
           Number(-reach, reach) * camera.up;
  }

  std::mt19937 random_{7};
};

bool Equal(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.towards == b.towards && a.up == b.up && a.right == b.right && a.xfov == b.xfov &&
         a.near == b.near && a.far == b.far && a.aspect == b.aspect && a.shift.x == b.shift.x && a.shift.y == b.shift.y;
}

TEST_F(CameraMoves, ACameraAimedAgainIsUnchanged) {
  for (int i = 0; i < 20000; ++i) {
    const Camera once = Aim(R3::Point{} + Vector(1e3), Vector(3), Vector(1e-3)).camera;
    const Camera twice = Aim(once.eye, once.towards, once.up).camera;
    ASSERT_TRUE(Equal(once, twice)) << CameraLine(once) << "\n" << CameraLine(twice);
  }
}

TEST_F(CameraMoves, PrintedCamerasReadBackHereAndInScenes) {
  for (int i = 0; i < 200; ++i) {
    Camera camera =
        Rotated(i % 2 == 0 ? AnyCamera() : AnyShiftedCamera(), R3::Point{} + Vector(5), {Number(-1, 1), Number(-1, 1)});
    camera.near = Number(0.001, 1), camera.far = Number(10, 1e6);
    const auto read = ReadCameraLine(CameraLine(camera));
    ASSERT_TRUE(read && Equal(camera, *read)) << CameraLine(camera);
    if (i % 19 == 0) {
      EXPECT_TRUE(Equal(camera, project::FromText(CameraLine(camera) + "\n").camera)) << CameraLine(camera);
    }
  }
  for (const char* line : {"", "camera", "camera 1 2 3", "camera 0 0 0  0 0 0  0 1 0  1 1 1",
                           "camera 0 0 0  0 0 1  0 1 0  2 1 1", "camera 0 0 0  0 0 1  0 1 x  1 1 1",
                           "camera 0 0 0  0 0 1  0 1 0  1 1 1 1", "camera 0 0 0  0 0 1  0 1 0  1 1 1 view 1 2",
                           "camera 0 0 0  0 0 1  0 1 0  1 1 1 view -1 2 2", "camera 0 0 0  0 0 inf  0 1 0  1 1 1"})
    EXPECT_FALSE(ReadCameraLine(line)) << line;
}

TEST_F(CameraMoves, RotationKeepsThePixelOfItsCenter) {
  for (int i = 0; i < 1000; ++i) {
    const Camera before = AnyCamera();
    const R3::Point center = InFrontOf(before);
    const Camera after = Rotated(before, center, {Number(-1, 1), Number(-1, 1)});
    const auto a = PixelOf(before, center, size), b = PixelOf(after, center, size);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(a->x, b->x, 1e-8);
    EXPECT_NEAR(a->y, b->y, 1e-8);
  }
}

TEST_F(CameraMoves, RotationIsThatOfTheCourse) {
  // A view along -z from z = 5; a drag to the right by a tenth rotates the eye to the left by 0.4 radians.
  Camera camera;
  camera.eye = {0, 0, 5};
  const Camera turned = Rotated(camera, {0, 0, 0}, {0.1, 0});
  EXPECT_NEAR(turned.eye.x, -5 * std::sin(0.4), 1e-12);
  EXPECT_NEAR(turned.eye.z, 5 * std::cos(0.4), 1e-12);
  EXPECT_NEAR(turned.eye.y, 0, 1e-12);
}

TEST_F(CameraMoves, AFullTurnInSingleDegreesReturnsToTheStart) {
  for (int i = 0; i < 10; ++i) {
    const Camera start = AnyCamera();
    const R3::Point center = InFrontOf(start);
    const R3::Vector axis = Vector(1);
    Camera camera = start;
    for (int degree = 0; degree < 360; ++degree) camera = Turned(camera, center, axis, std::numbers::pi / 180);
    const double scale = Length(start.eye - center);
    EXPECT_LT(Length(camera.eye - start.eye), 1e-9 * scale);
    EXPECT_LT(Length(camera.towards - start.towards), 1e-9);
    EXPECT_LT(Length(camera.up - start.up), 1e-9);
  }
}

TEST_F(CameraMoves, TheGrabbedPointStaysUnderThePointerOfAPan) {
  for (int i = 0; i < 1000; ++i) {
    const Camera before = AnyCamera();
    const R3::Point grabbed = InFrontOf(before);
    const R2::Point drag{Number(-0.5, 0.5), Number(-0.5, 0.5)};
    const Camera after = Panned(before, DepthOf(before, grabbed), drag, size);
    const auto a = PixelOf(before, grabbed, size), b = PixelOf(after, grabbed, size);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(b->x - a->x, drag.x * size.width, 1e-7);
    EXPECT_NEAR(b->y - a->y, drag.y * size.height, 1e-7);
  }
}

TEST_F(CameraMoves, ZoomIsTheCoursesAndKeepsTheCentersPixel) {
  for (int i = 0; i < 100; ++i) {
    const Camera before = AnyCamera();
    const R3::Point center = InFrontOf(before);
    const Camera after = Zoomed(before, center, {0.1, 0.05});
    EXPECT_NEAR(Length(after.eye - center), Length(before.eye - center) / std::exp(0.3), 1e-9);
    EXPECT_NEAR(PixelOf(before, center, size)->x, PixelOf(after, center, size)->x, 1e-8);
  }
}

TEST_F(CameraMoves, FramedBoxesFillMostOfTheImageAndStayInside) {
  for (int i = 0; i < 500; ++i) {
    R3::Box box;
    box.Extend(R3::Point{} + Vector(100));
    box.Extend(R3::Point{} + Vector(100));
    const Camera camera = Framed(i % 2 == 0 ? AnyCamera() : AnyShiftedCamera(), box, size);
    double widest = 0;
    for (int c = 0; c < 8; ++c) {
      const auto pixel = PixelOf(camera, box.Corner(c), size);
      ASSERT_TRUE(pixel);
      widest = std::max({widest, std::abs(2 * pixel->x / size.width - 1), std::abs(2 * pixel->y / size.height - 1)});
    }
    EXPECT_GE(widest, 0.8);
    EXPECT_LE(widest, 0.95);
  }
}

TEST_F(CameraMoves, TheTurntableKeepsTheHorizon) {
  const R3::Vector vertical{0, 1, 0};
  Camera camera = AnyCamera();
  const R3::Point center = InFrontOf(camera);
  for (int i = 0; i < 1000; ++i) {
    camera = RotatedUpright(camera, center, vertical, {Number(-0.3, 0.3), Number(-0.3, 0.3)});
    EXPECT_NEAR(Dot(camera.right, vertical), 0, 1e-9);
    EXPECT_GT(Dot(camera.up, vertical), 0);
  }
}

// Otherwise an axis view from above would spin at the first touch.
TEST_F(CameraMoves, TheTurntableTurnsAViewAlongTheVerticalSmoothly) {
  const R3::Vector vertical{0, 1, 0};
  const Camera camera = FromAxis(AnyCamera(), {}, {0, -1, 0}, {0, 0, -1});
  const Camera turned = RotatedUpright(camera, {}, vertical, {0.01, 0});
  EXPECT_NEAR(Dot(turned.up, camera.up), 1, 0.01);
  const Camera lifted = RotatedUpright(camera, {}, vertical, {0, 0.1});
  EXPECT_GT(Dot(lifted.up, vertical), 0);
}

TEST_F(CameraMoves, PixelsAndRaysAgree) {
  for (int i = 0; i < 100; ++i) {
    const Camera camera = i % 2 == 0 ? AnyCamera() : AnyShiftedCamera();
    const R2::Point pixel{Number(0, size.width), Number(0, size.height)};
    const R3::Ray ray = camera.Through(pixel.x, pixel.y, size.width, size.height);
    const auto back = PixelOf(camera, ray.At(Number(0.1, 100)), size);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, pixel.x, 1e-6);
    EXPECT_NEAR(back->y, pixel.y, 1e-6);
  }
  EXPECT_FALSE(PixelOf(Camera{}, {0, 0, 1}, size)) << "behind the eye";
}

TEST_F(CameraMoves, DrawingAgreesWithRays) {
  const R3::Box box{{-20, -20, -20}, {20, 20, 20}};
  const DrawingSpace space = DrawingSpace::Of(box);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = i % 2 == 0 ? AnyCamera() : AnyShiftedCamera();
    const R3::Point p = InFrontOf(camera);
    const ClipMatrix m = ClipFromDrawing(camera, space, box, size);
    const auto at = space.At(p);
    std::array<double, 4> clip{};
    for (std::size_t r = 0; r < 4; ++r) clip[r] = m[r] * at[0] + m[4 + r] * at[1] + m[8 + r] * at[2] + m[12 + r];
    const auto pixel = PixelOf(camera, p, size);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR((clip[0] / clip[3] + 1) / 2 * size.width, pixel->x, 0.01);
    EXPECT_NEAR((clip[1] / clip[3] + 1) / 2 * size.height, pixel->y, 0.01);
  }
}

TEST_F(CameraMoves, AnglesStayWithinTheirLimits) {
  Camera camera;
  for (int i = 0; i < 100; ++i) camera = WithAngle(camera, 1.1);
  EXPECT_LE(camera.xfov, 1.5);
  for (int i = 0; i < 200; ++i) camera = WithAngle(camera, 1 / 1.1);
  EXPECT_GE(camera.xfov, 0.005);
}

}  // namespace
}  // namespace ray
