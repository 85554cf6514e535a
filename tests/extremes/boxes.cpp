// Boxes without thickness, and rays that touch boxes exactly. Oracle: rational arithmetic on small whole numbers.

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

/// Whether origin + t direction meets the closed box for some t >= 0, in whole numbers.
bool Touches(const std::array<int, 3>& low, const std::array<int, 3>& high, const std::array<int, 3>& o,
             const std::array<int, 3>& d) {
  // The interval as fractions with positive denominators; starts as [0, infinity).
  long enter_n = 0, enter_d = 1, leave_n = 1, leave_d = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0) {
      if (o[i] < low[i] || o[i] > high[i]) return false;
      continue;
    }
    long near = (d[i] > 0 ? low[i] : high[i]) - o[i], far = (d[i] > 0 ? high[i] : low[i]) - o[i], by = d[i];
    if (by < 0) near = -near, far = -far, by = -by;
    if (near * enter_d > enter_n * by) enter_n = near, enter_d = by;
    if (far * leave_d < leave_n * by) leave_n = far, leave_d = by;
  }
  return enter_n * leave_d <= leave_n * enter_d && leave_n >= 0;
}

void CompareOnTheLattice(Draw draw, int flat_axes, int count) {
  for (int n = 0; n < count; ++n) {
    std::array<int, 3> low, high, o, d;
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = draw.Whole(-5, 5);
      high[i] = static_cast<int>(i) < flat_axes ? low[i] : draw.Whole(-5, 5);
      if (low[i] > high[i]) std::swap(low[i], high[i]);
      o[i] = draw.Whole(-5, 5);
      d[i] = draw.Whole(0, 1) ? 0 : draw.Whole(-5, 5);
    }
    if (d[0] == 0 && d[1] == 0 && d[2] == 0) continue;
    // Zeros of either sign.
    const auto component = [&](std::size_t i) { return d[i] == 0 && draw.Whole(0, 1) ? -0.0 : d[i]; };
    const R3::Ray ray{{static_cast<double>(o[0]), static_cast<double>(o[1]), static_cast<double>(o[2])},
                      {component(0), component(1), component(2)}};
    const R3::Box box{{static_cast<double>(low[0]), static_cast<double>(low[1]), static_cast<double>(low[2])},
                      {static_cast<double>(high[0]), static_cast<double>(high[1]), static_cast<double>(high[2])}};
    const bool expected = Touches(low, high, o, d);
    ASSERT_EQ(Entry(box, R3::BoxRay(ray), 0).has_value(), expected) << oracle::Hex(ray);
  }
}

TEST(Extremes, C1_BoxesAndRaysOnTheLatticeAreNeverConfused) {
  CompareOnTheLattice(Draw(301), 0, Count(1'000'000, 100'000'000));
}

TEST(Extremes, C2_FlatBoxesAndRaysOnTheLatticeAreNeverConfused) {
  CompareOnTheLattice(Draw(302), 1, Count(300'000, 100'000'000));
}

TEST(Extremes, B7_ABoxWithoutThicknessIsARectangle) {
  const auto flat = R3::MakeShape("box", {-1, 0, -1, 1, 0, 1});
  for (const double y : {3.0, -3.0}) {
    const auto hit = flat->Intersect({{0.5, y, 0.5}, {0, -y, 0}}, 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 1);
    const auto at = flat->At({{0.5, y, 0.5}, {0, -y, 0}}, *hit, 0);
    EXPECT_EQ(at.position, (R3::Point{0.5, 0, 0.5}));
    EXPECT_EQ(std::abs(at.normal.y), 1);
  }
  EXPECT_FALSE(flat->Intersect({{1.5, 3, 0.5}, {0, -1, 0}}, 0));
}

TEST(Extremes, B7_BoxesThatAreLinesOrPointsAreNeverHit) {
  const auto line = R3::MakeShape("box", {-1, 0, 0, 1, 0, 0}), point = R3::MakeShape("box", {1, 2, 3, 1, 2, 3});
  Draw draw(303);
  for (int i = 0; i < 1000; ++i) {
    const R3::Point origin = R3::Point{} + 5 * draw.Direction();
    EXPECT_FALSE(line->Intersect({origin, R3::Point{draw.Between(-1, 1), 0, 0} - origin}, 0));
    EXPECT_FALSE(point->Intersect({origin, R3::Point{1, 2, 3} - origin}, 0));
  }
  EXPECT_FALSE(line->Intersect({{-5, 0, 0}, {1, 0, 0}}, 0));
  EXPECT_TRUE(line->IsDegenerate());
  EXPECT_TRUE(point->IsDegenerate());
}

TEST(Extremes, B7_ReversedCornersAreSorted) {
  const auto sorted = R3::MakeShape("box", {-1, -2, -3, 1, 2, 3}),
             reversed = R3::MakeShape("box", {1, -2, 3, -1, 2, -3});
  EXPECT_EQ(sorted->Bounds(0), reversed->Bounds(0));
}

/// Whether the exact ray touches the closed box in its range, in 113 bits.
bool Touches(const R3::Box& box, const R3::Ray& ray) {
  Quad enter = ray.t_min, leave = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const Quad o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.low[axis] || o > box.high[axis]) return false;
      continue;
    }
    const Quad a = (box.low[axis] - o) / d, b = (box.high[axis] - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

TEST(Extremes, C3_RaysThatTouchABoundingBoxAreNeverLost) {
  Draw draw(303);
  int touching = 0;
  for (int n = 0, count = Count(300'000, 100'000'000); n < count; ++n) {
    const R3::Vector offset = std::array{0.0, 1e4, 1e8}[static_cast<std::size_t>(n % 3)] * draw.Direction();
    R3::Box box;
    for (int i = 0; i < 3; ++i) box.Extend(R3::Point{} + offset + draw.Direction());
    // On each axis a corner, the middle or anywhere between: corners, edges and faces of the box.
    const auto at = [&](int axis) {
      const double low = box.low[axis], high = box.high[axis];
      return std::array{low, high, low / 2 + high / 2,
                        draw.Between(low, high)}[static_cast<std::size_t>(draw.Whole(0, 3))];
    };
    const R3::Point target{at(0), at(1), at(2)}, origin = R3::Point{} + offset + draw.Scale(-1, 2) * draw.Direction();
    const R3::Ray ray{origin, target - origin};
    if (!Touches(box, ray)) continue;
    ++touching;
    ASSERT_TRUE(Entry(box, R3::BoxRay(ray), 0)) << oracle::Hex(ray);
  }
  EXPECT_GT(touching, 100'000);
}

}  // namespace
