#include "source/integrate/modes/Outlined.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "source/text/EnumNames.h"
#include "tests/Project.h"

namespace ray {
namespace {

constexpr int outline_side = 100;

R2::Image WithOutline(const std::string& scene, double thickness, RenderMode mode = RenderMode::flat) {
  RenderSettings settings = project::Sized(outline_side);
  settings.mode = mode;
  settings.trace.outline.width = thickness;
  return project::Render(project::Stage(project::FromText(scene)), settings).image;
}

constexpr const char* white_material =
    "background 1 1 1 ambient 0 0 0 dir_light 0 0 0  0 -1 0 material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 0 ";

/// A view from a distance of 10, where the image is 10 wide.
std::string WhiteScene(const std::string& shapes, const std::string& towards = "0 0 -1  0 1 0") {
  return "camera 0 0 10  " + towards + "  0.4636476090008061  0.01 100 " + white_material + shapes;
}

int BlackIn(const R2::Image& image, int x0, int x1, int row) {
  int black = 0;
  for (int x = x0; x < x1; ++x) black += image.At(x, row) == R2::Color{};
  return black;
}

// The ball has the background's color: only lines are visible.
TEST(Outline, OfABallHasTheRequestedWidth) {
  for (const double thickness : {1.0, 2.0, 4.0, 8.0}) {
    const R2::Image image = WithOutline(WhiteScene("sphere 0  0 0 0  3"), thickness);
    for (const auto& [x0, x1] : {std::pair{0, outline_side / 2}, {outline_side / 2, outline_side}})
      EXPECT_NEAR(BlackIn(image, x0, x1, outline_side / 2), thickness, 1) << "a line of " << thickness << " pixels";
    EXPECT_EQ(image.At(outline_side / 2, outline_side / 2), (R2::Color{1, 1, 1}));
    EXPECT_EQ(image.At(2, 2), (R2::Color{1, 1, 1}));
  }
}

// Slants of up to 62 degrees, beyond which the horizon would be visible.
TEST(Outline, NeverAppearsOnASlantedPlane) {
  for (const char* normal : {"0 0 1", "1 0 1", "-1.3 .4 1", "0 1.9 1"}) {
    const R2::Image image = WithOutline(WhiteScene("plane 0  0 0 0  " + std::string(normal)), 2);
    for (int row = 0; row < outline_side; ++row) EXPECT_EQ(BlackIn(image, 0, outline_side, row), 0) << normal;
  }
}

TEST(Outline, IsDrawnAtCreasesAndAtStepsInDepth) {
  // Walls that meet in the middle at a right angle, 45 degrees to either outline_side.
  const R2::Image corner = WithOutline(WhiteScene("plane 0  0 0 0  1 0 1 plane 0  0 0 0  -1 0 1"), 2);
  EXPECT_NEAR(BlackIn(corner, 0, outline_side, outline_side / 2), 2, 1);
  // Two sheets with the same normal, one unit apart in depth, the nearer one on the left.
  const R2::Image step = WithOutline(WhiteScene("plane 0  0 0 -1  0 0 1 tri 0  -90 -90 0  0 -90 0  0 90 0 "
                                                "tri 0  -90 -90 0  0 90 0  -90 90 0"),
                                     2);
  EXPECT_NEAR(BlackIn(step, 0, outline_side, outline_side / 2), 2, 1);
  // A thousandth apart is too little for a line.
  const R2::Image flush = WithOutline(WhiteScene("plane 0  0 0 -.001  0 0 1 tri 0  -90 -90 0  0 -90 0  0 90 0"), 2);
  EXPECT_EQ(BlackIn(flush, 0, outline_side, outline_side / 2), 0);
}

TEST(Outline, AppliesToAnyModeAndCostsNothingWithoutAWidth) {
  const std::string scene = WhiteScene("sphere 0  0 0 0  3 dir_light 1 1 1  0 0 -1");
  for (const RenderMode mode : {RenderMode::whitted, RenderMode::path, RenderMode::gooch, RenderMode::toon}) {
    EXPECT_NEAR(BlackIn(WithOutline(scene, 3, mode), 0, outline_side / 2, outline_side / 2), 3, 1) << NameOf(mode);
    RenderSettings settings = project::Sized(outline_side);
    settings.mode = mode;
    settings.trace.max_depth = 0;
    const auto rays = project::Render(project::Stage(project::FromText(scene)), settings).rays;
    EXPECT_EQ(rays[RayKind::camera].rays, static_cast<std::uint64_t>(outline_side * outline_side)) << NameOf(mode);
  }
}

TEST(Outline, IsTheSameInACrop) {
  const std::string scene = WhiteScene("sphere 0  0 0 0  3 box 0  -4 -4 0  -2 -2 2");
  const R2::Image whole = WithOutline(scene, 2);
  RenderSettings settings = project::Sized(outline_side);
  settings.mode = RenderMode::flat;
  settings.trace.outline.width = 2;
  settings.crop = PixelRectangle{10, 20, 60, 50};
  const R2::Image part = project::Render(project::Stage(project::FromText(scene)), settings).image;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 50; ++x) EXPECT_EQ(part.At(x, y), whole.At(x + 10, y + 20));
}

TEST(Toon, HasTheRequestedTonesAndDarkness) {
  for (const int bands : {1, 3, 7}) {
    RenderSettings settings = project::Sized(outline_side);
    settings.mode = RenderMode::toon;
    settings.trace.toon_bands = bands;
    const std::string scene = WhiteScene("sphere 0  0 0 0  3 dir_light .9 .9 .9  -1 0 -1");
    const R2::Image image = project::Render(project::Stage(project::FromText(scene)), settings).image;
    std::set<double> tones;
    for (int x = 22; x < 78; ++x) tones.insert(image.At(x, outline_side / 2).r);
    EXPECT_EQ(tones.size(), static_cast<std::size_t>(bands) + 1);
    EXPECT_EQ(*tones.begin(), 0) << "away from the light";
    EXPECT_NEAR(*tones.rbegin(), 0.9, 1e-6) << "towards it";
  }
}

// With exponent 10, V.R is at least 0.933 where its power is above a half: within 21 degrees, or 10.5 of the normal.
TEST(Toon, HighlightsAreSpotsWithAnEdge) {
  RenderSettings settings = project::Sized(outline_side);
  settings.mode = RenderMode::toon;
  const std::string scene =
      "camera 0 0 1000  0 0 -1  0 1 0  .0049999583  1 2000 background 0 0 0 material 0 0 0  0 0 0  1 .5 .25  0 0 0  "
      "0 0 0  10 1 0 sphere 0  0 0 0  5 dir_light 1 1 1  0 0 -1";
  const R2::Image image = project::Render(project::Stage(project::FromText(scene)), settings).image;
  int lit = 0;
  for (int x = 0; x < outline_side; ++x) {
    const R2::Color c = image.At(x, outline_side / 2);
    EXPECT_TRUE(c == R2::Color{} || c == (R2::Color{1, 0.5, 0.25}));
    lit += !IsBlack(c);
  }
  EXPECT_NEAR(lit, outline_side * std::sin(0.5 * std::acos(std::pow(0.5, 0.1))), 2);
}

}  // namespace
}  // namespace ray
