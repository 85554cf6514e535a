#include "source/inspect/ImageLines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/parse/Parse.h"
#include "tests/Folder.h"

namespace ray {
namespace {

constexpr int width = 80, height = 60;

Camera CameraOf(const std::string& projection) {
  const project::Folder folder;
  folder.Write("view.scn", "camera 0 0 0  0 0 -1  0 1 0  0.6  1 100\n" + projection + "sphere -1  0 0 -5  1\n");
  return Parse(folder / "view.scn", {}).scene.camera;
}

const auto all_visible = [](const R3::Point&, const R3::Ray&, const R2::Point&) { return true; };

double Distance(const R2::Point& a, const R2::Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(ImageLines, FollowEachProjectionWithoutGaps) {
  for (const char* projection :
       {"", "projection fisheye 170\n", "projection latlong\n", "projection orthographic 8\n"}) {
    SCOPED_TRACE(projection);
    const Camera camera = CameraOf(projection);
    const R3::Point from{-2, -1, -4}, to{2.5, 1, -9};
    const auto lines = ImageLines(camera, width, height, all_visible).Of(from, to);
    ASSERT_FALSE(lines.empty());
    EXPECT_LE(Distance(lines.front().from, *camera.PlaceOf(from, width, height)), 1e-9);
    EXPECT_LE(Distance(lines.back().to, *camera.PlaceOf(to, width, height)), 1e-9);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_FALSE(lines[i].is_hidden);
      if (i > 0) {
        EXPECT_EQ(Distance(lines[i].from, lines[i - 1].to), 0);
      }
      // Each end of a piece is seen along a ray that passes the segment.
      const auto ray = camera.RayThrough(lines[i].to.x, lines[i].to.y, width, height);
      ASSERT_TRUE(ray);
      const R3::Vector normal = Cross(ray->direction, to - from);
      EXPECT_LE(std::abs(Dot(Unit(normal), from - ray->origin)), 1e-9);
    }
  }
}

TEST(ImageLines, EndBeforeAPinhole) {
  const ImageLines lines(CameraOf(""), width, height, all_visible);
  EXPECT_TRUE(lines.Of({0, 0, 1}, {1, 0, 2}).empty());
  EXPECT_FALSE(lines.Of({0, 1, 3}, {0, 0, -3}).empty());
}

TEST(ImageLines, AreTornAtThePanoramasEdge) {
  const ImageLines lines(CameraOf("projection latlong\n"), width, height, all_visible);
  bool is_left = false, is_right = false;
  for (const ImageLine& line : lines.Of({-1, 0, 5}, {1, 0, 5})) {
    EXPECT_LT(Distance(line.from, line.to), width / 2.0) << "not across the whole image";
    (line.from.x < width / 2.0 ? is_left : is_right) = true;
  }
  EXPECT_TRUE(is_left && is_right);
}

TEST(ImageLines, AreHiddenPieceByPiece) {
  const auto in_the_left_half = [](const R3::Point&, const R3::Ray&, const R2::Point& place) {
    return place.x < width / 2.0;
  };
  const auto lines = ImageLines(CameraOf(""), width, height, in_the_left_half).Of({-1, 0, -5}, {1, 0, -5});
  EXPECT_FALSE(lines.front().is_hidden);
  EXPECT_TRUE(lines.back().is_hidden);
}

}  // namespace
}  // namespace ray
