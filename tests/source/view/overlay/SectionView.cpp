#include "source/view/overlay/SectionView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

constexpr double half_angle = 0.4;

/// The lines of one color in the cut along the middle row of a ball of radius 1, seen from so far.
Lines MarkFrom(double distance, const Rgba& color, const RenderSettings& settings = {}) {
  const Folder folder;
  folder.Write("ball.scn",
               "camera 0 0 " + std::to_string(distance) + "  0 0 -1  0 1 0  0.4  0.01 100 sphere -1 0 0 0 1");
  const LoadedScene scene(folder / "ball.scn", {}, {});
  SectionView section;
  section.Toggle();
  section.Cut(scene, settings, {}, {400, 400});
  Lines marks;
  for (const Vertex& vertex : section.Drawing(scene, {}, 1).lines)
    if (vertex.color == color) marks.push_back(vertex);
  return marks;
}

const Rgba dot{255, 230, 120, 255}, screen{120, 255, 160, 255};

R2::Point MiddleOf(const Lines& lines) {
  R2::Point sum;
  for (const Vertex& vertex : lines) {
    sum.x += vertex.at[0] / static_cast<double>(lines.size());
    sum.y += vertex.at[1] / static_cast<double>(lines.size());
  }
  return sum;
}

TEST(SectionView, HasADotForTheCameraAndTheLineOfItsScreenBeforeIt) {
  RenderSettings settings;
  settings.width = settings.height = 100;
  const Lines eye = MarkFrom(4, dot, settings), line = MarkFrom(4, screen, settings);
  ASSERT_FALSE(eye.empty());
  ASSERT_EQ(line.size(), 2u);
  const R2::Point at = MiddleOf(eye);
  EXPECT_NEAR(at.x, 0, 1e-3);
  EXPECT_TRUE(at.y > -1 && at.y < -0.5) << "below the ball, in the panel";
  for (const Vertex& vertex : eye)
    EXPECT_LE(std::hypot(vertex.at[0] - at.x, vertex.at[1] - at.y), 5 / 200.0) << "a few pixels";
  const double way = line[0].at[1] - at.y;
  EXPECT_GT(way, 0.01);
  EXPECT_NEAR(line[1].at[1], line[0].at[1], 1e-6);
  EXPECT_NEAR(line[1].at[0] - line[0].at[0], 2 * way * std::tan(half_angle), 2e-3 * way);
}

TEST(SectionView, HasTheScreenAtTheFocusDistanceOfALens) {
  RenderSettings settings;
  settings.width = settings.height = 100;
  settings.camera.aperture = 0.1;
  settings.camera.focus = 4;  // where the ball's middle is
  const Lines eye = MarkFrom(4, dot, settings), line = MarkFrom(4, screen, settings);
  settings.camera.focus = 2;
  const Lines nearer = MarkFrom(4, screen, settings);
  ASSERT_TRUE(line.size() == 2 && nearer.size() == 2);
  const double from = MiddleOf(eye).y;
  EXPECT_NEAR((line[0].at[1] - from) / (nearer[0].at[1] - from), 2, 1e-2);
}

TEST(SectionView, LeavesACameraFarAwayOutsideSoThatTheSceneStaysLarge) {
  RenderSettings settings;
  settings.width = settings.height = 100;
  EXPECT_LT(MiddleOf(MarkFrom(100, dot, settings)).y, -10);
}

}  // namespace
}  // namespace ray
