#include <gtest/gtest.h>

#include <cmath>

#include "source/app/manual/Manual.h"
#include "source/scene/CameraKind.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

const std::string view = "camera 0 0 5  0 0 -1  0 1 0  0.5  0.01 100\nsphere -1  0 0 0  1\n";

ParseOptions With(const CameraChange& change) {
  ParseOptions options;
  options.camera = change;
  return options;
}

Camera CameraOf(const std::string& text, const CameraChange& change = {}) {
  return ParseText(text, With(change)).scene.camera;
}

CameraChange Projected(const std::string& name, std::optional<double> fov = {}) {
  CameraChange change;
  change.projection = name;
  change.fov = fov;
  return change;
}

TEST(Projection, MayComeBeforeOrAfterTheCamera) {
  for (const std::string& text : {view + "projection fisheye 220\n", "projection fisheye 220\n" + view}) {
    EXPECT_EQ(CameraOf(text).kind, FindCameraKind("fisheye"));
    EXPECT_EQ(CameraOf(text).extent, 220);
    EXPECT_EQ(CameraOf(text).xfov, 0.5);
  }
  EXPECT_EQ(CameraOf("projection cylinder 300 sphere -1 0 0 0 1").extent, 300) << "of the default camera";
}

TEST(Projection, WithoutANumberItsAngleIsThatOfTheCamera) {
  const Camera camera = CameraOf(view + "projection fisheye");
  EXPECT_DOUBLE_EQ(camera.Extent(), 180 / std::numbers::pi);  // two times half a radian
}

TEST(Projection, OrthographicViewsMatchThePinholeWidthAtTheMiddle) {
  EXPECT_DOUBLE_EQ(CameraOf(view + "projection orthographic").extent, 2 * 5 * std::tan(0.5));
  EXPECT_EQ(CameraOf(view + "projection orthographic 3").extent, 3);
  EXPECT_EQ(CameraOf("camera 0 0 0  0 0 -1  0 1 0  0.5  0.01 100 projection orthographic sphere -1 0 0 0 1").extent,
            2 * std::sqrt(3.0))
      << "the diagonal of the box that the eye is in";
  EXPECT_DOUBLE_EQ(CameraOf("camera 0 0 0  0 0 -1  0 1 0  0.5  0.01 100 projection orthographic").extent,
                   2 * std::tan(0.5));
}

TEST(Projection, OptionsOverrideTheScene) {
  const std::string scene = view + "projection fisheye 220\n";
  EXPECT_EQ(CameraOf(scene, Projected("fisheye")).extent, 220);
  EXPECT_EQ(CameraOf(scene, Projected("cylinder", 300)).extent, 300);
  EXPECT_EQ(CameraOf(scene, Projected("cylinder")).Extent(), CameraOf(view).Fov());
  EXPECT_TRUE(CameraOf(scene, Projected("pinhole")).IsPinhole());
  EXPECT_DOUBLE_EQ(CameraOf(scene, Projected("pinhole", 90)).Fov(), 90);
  EXPECT_EQ(CameraOf(scene, Projected("", 90)).extent, 90);
  CameraChange moved;
  moved.eye = R3::Point{1, 2, 3};
  EXPECT_EQ(CameraOf(scene, moved).extent, 220);
}

TEST(Projection, UnsupportedAnglesAreRefused) {
  const auto refusal = [](const CameraChange& change) { return ReportOf(view, With(change)); };
  EXPECT_EQ(refusal(Projected("", 180)),
            "scene.scn: error: projection pinhole has an angle between 0 and 180 degrees, and -fov is 180");
  EXPECT_EQ(refusal(Projected("latlong", 90)), "scene.scn: error: projection latlong has no angle, and -fov is 90");
  EXPECT_TRUE(Contains(refusal(Projected("orthographic", 90)), "orthographic has no angle"));
  EXPECT_EQ(refusal(Projected("fisheye", 360)), "");
}

TEST(Projection, EveryKindIsInTheSceneManual) {
  const std::string manual = ManualPage("scn", Program::raypro);
  for (const CameraKind* kind : CameraKinds()) {
    EXPECT_TRUE(Contains(manual, std::string(kind->name) + ": ")) << kind->name;
    EXPECT_GT(std::string(kind->about).size(), 30u) << kind->name;
    EXPECT_EQ(FindCameraKind(kind->name), kind);
  }
  EXPECT_EQ(FindCameraKind("Fisheye"), nullptr);
}

#ifdef RAYPRO_YAML
TEST(Projection, IsAKeyOfGroningensCamera) {
  const Folder folder;
  const auto camera = [&](const std::string& keys) {
    return Parse(folder.Write("a.yaml",
                              "Camera: {eye: [0, 0, 10], center: [0, 0, 0], up: [0, .5, 0], viewSize: [40, 20]" + keys +
                                  "}\nObjects: []\n"),
                 {})
        .scene.camera;
  };
  EXPECT_TRUE(camera("").IsPinhole());
  EXPECT_EQ(camera(", projection: fisheye, fov: 200").extent, 200);
  EXPECT_EQ(camera(", projection: fisheye").Extent(), camera("").Fov());
  EXPECT_EQ(camera(", projection: orthographic").extent, 20) << "a pixel is as wide as up is long";
  EXPECT_EQ(camera(", projection: Orthographic, viewWidth: 7").extent, 7);
}
#endif

TEST(Projection, IsAKeyOfCs315sCamera) {
  const Folder folder;
  const auto file = folder.Write("a.json", R"({"camera": {"eye": [0, 0, 5], "at": [0, 0, 0], "up": [0, 1, 0],
      "fovy": 40, "aspect": 2, "projection": "cylinder", "fov": 270}, "bounce_depth": 1, "shadow_bias": 0.001,
      "lights": [], "materials": [], "surfaces": []})");
  const Camera camera = Parse(file, {}).scene.camera;
  EXPECT_EQ(camera.kind, FindCameraKind("cylinder"));
  EXPECT_EQ(camera.extent, 270);
  EXPECT_EQ(camera.aspect, 2);
}

}  // namespace
}  // namespace ray
