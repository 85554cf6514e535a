#include "source/inspect/SectionView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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
  for (const Vertex& vertex : section.Drawing(scene, {}, LetterSize{}).lines)
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

TEST(SectionView, MarksTheCameraWithADotAndItsScreenLine) {
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

TEST(SectionView, LeavesDistantCamerasOutsideToKeepTheSceneLarge) {
  RenderSettings settings;
  settings.width = settings.height = 100;
  EXPECT_LT(MiddleOf(MarkFrom(100, dot, settings)).y, -10);
}

/// The cut of a ball of radius 1 with a light above it, by a plane so many keys after the camera's.
SliceAxes CutOfBall(int plane, const DebugRayCounts& counts = {}) {
  const Folder folder;
  folder.Write("ball.scn",
               "camera 0 1 4  0 -0.25 -1  0 1 0  0.4  0.01 100 point_light 1 1 1  0 5 0  1 0 0 sphere -1 0 0 0 1");
  const LoadedScene scene(folder / "ball.scn", {}, {});
  RenderSettings settings;
  settings.width = settings.height = 100;
  SectionView section;
  section.Toggle();
  for (int i = 0; i < plane; ++i) section.NextPlane();
  section.Cut(scene, settings, {}, {400, 400}, counts);
  return section.Drawing(scene, {}, LetterSize{});
}

std::vector<Vertex> OfColor(const SliceAxes& axes, const Rgba& color, bool with_alpha = true) {
  std::vector<Vertex> found;
  for (const Vertex& v : axes.lines)
    if (std::equal(color.begin(), color.begin() + (with_alpha ? 4 : 3), v.color.begin())) found.push_back(v);
  return found;
}

// Every sixteenth crossing was one that enters, since enters and leaves take turns: normals stood on one half alone.
TEST(SectionView, NormalsStandEvenlyRoundAnOutline) {
  const auto normals = OfColor(CutOfBall(3), {255, 120, 220, 160});
  std::array<int, 8> by_octant{};
  for (std::size_t i = 0; i + 1 < normals.size(); i += 2) {
    const double x = normals[i + 1].at[0] - normals[i].at[0], y = normals[i + 1].at[1] - normals[i].at[1];
    ++by_octant[static_cast<std::size_t>(std::floor(std::atan2(y, x) / (std::acos(-1.0) / 4))) & 7];
  }
  const auto [least, most] = std::ranges::minmax(by_octant);
  EXPECT_GE(least, 5);
  EXPECT_LE(most, 2 * least);
}

TEST(SectionView, EveryPlaneHasTheEyeItsScreenAndRays) {
  for (int plane = 0; plane < 4; ++plane) {
    const SliceAxes axes = CutOfBall(plane);
    EXPECT_FALSE(OfColor(axes, dot).empty()) << plane;
    EXPECT_EQ(OfColor(axes, screen).size(), 2u) << plane;
    EXPECT_FALSE(OfColor(axes, {240, 240, 240, 255}, false).empty()) << plane;
  }
  // So many of 100 pixels, of 16 pieces each.
  EXPECT_EQ(OfColor(CutOfBall(1, {1, 1, 4}), {240, 240, 240, 255}, false).size(), 4u * 2 * 16);
  EXPECT_EQ(OfColor(CutOfBall(1), {240, 240, 240, 255}, false).size(), 50u * 2 * 16);
}

// Along x and y a floor lies flat; along y and z it stood on edge.
TEST(SectionView, TheVerticalRunsUpwardWhereThePlaneHasIt) {
  const auto names = [](int plane) {
    std::string all;
    for (const Label& label : CutOfBall(plane).labels)
      if (label.text == "x" || label.text == "y" || label.text == "z") all += label.text;
    return all;
  };
  EXPECT_EQ(names(1), "xz");
  EXPECT_EQ(names(2), "zy");
  EXPECT_EQ(names(3), "xy");
}

// Shadow rays to a light above the plane were drawn as if they crossed what lies between in it.
TEST(SectionView, RaysAreFainterWhereTheyAreOffThePlane) {
  const auto shadows = OfColor(CutOfBall(0), {255, 220, 60, 255}, false);
  ASSERT_FALSE(shadows.empty());
  int faint = 0;
  for (std::size_t i = 0; i < shadows.size(); i += 2 * 16) {
    EXPECT_GT(shadows[i].color[3], 200) << "it begins in the plane";
    faint += shadows[i + 2 * 16 - 1].color[3] < 60;
  }
  EXPECT_GT(faint, 0);
}

}  // namespace
}  // namespace ray
