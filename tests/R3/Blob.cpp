// Blobs, compared with their field in 113-bit arithmetic.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "R3/ShapeKind.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

using Numbers = std::vector<double>;

/// Returns the field minus the threshold.
Quad FieldAt(const Numbers& numbers, const R3::Ray& ray, Quad t) {
  Quad sum = -Quad(numbers[0]);
  const oracle::Vector p = oracle::Of(ray.origin) + t * oracle::Of(ray.direction);
  for (std::size_t i = 1; i < numbers.size(); i += 5) {
    const oracle::Vector d = p - oracle::Vector{numbers[i], numbers[i + 1], numbers[i + 2]};
    const Quad radius = numbers[i + 3], q = 1 - oracle::Dot(d, d) / (radius * radius);
    if (q > 0) sum += Quad(numbers[i + 4]) * q * q * q;
  }
  return sum;
}

Numbers RandomBlob(Draw& draw) {
  Numbers numbers{draw.Between(0.2, 1)};
  for (int i = draw.Whole(1, 6); i > 0; --i) {
    const R3::Vector center = draw.Between(0, 1.2) * draw.Direction();
    const double strength = draw.Whole(0, 3) ? draw.Between(0.5, 2) : -draw.Between(0.5, 2);
    numbers.insert(numbers.end(), {center.x, center.y, center.z, draw.Scale(-0.5, 0), strength});
  }
  return numbers;
}

/// Returns a sentence if one of the crossings found is wrong, or one is missed, by the samples of the line; otherwise
/// an empty text.
///   least   if the field is nearer to the threshold than this, rounding decides
std::string Fault(const Numbers& numbers, const R3::Ray& ray, const std::vector<double>& found, int samples) {
  constexpr double least = 1e-12;
  if (found.size() % 2 != 0) return "it is entered and not left";
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    const Quad between = FieldAt(numbers, ray, (Quad(found[i]) + Quad(found[i + 1])) / 2);
    if (oracle::Abs(between) > least && (between > 0) != (i % 2 == 0)) return "a crossing is none";
  }
  for (const double t : found)
    if (oracle::Abs(FieldAt(numbers, ray, t)) > 1e-12) return "a crossing is off the surface";
  std::size_t next = 0;
  for (int i = 0; i <= samples; ++i) {
    const double t = 10.0 * i / samples;
    while (next < found.size() && found[next] <= t) ++next;
    const Quad field = FieldAt(numbers, ray, t);
    if (oracle::Abs(field) > least && (field > 0) != (next % 2 == 1)) return "a crossing is missed";
  }
  return {};
}

R3::Ray RayThroughBlobs(Draw& draw) {
  const R3::Vector d = draw.Direction();
  return {R3::Point{} + draw.Between(0, 1.5) * draw.Direction() - 5 * d, d};
}

TEST(Blob, OfOneBallIsASphere) {
  // 2 (1 - d^2 / 9)^3 = 0.25 at d = 3 sqrt(1 / 2).
  const auto blob = R3::MakeShape("blob", {0.25, 1, 2, 3, 3, 2});
  const double radius = 3 * std::sqrt(0.5);
  const auto sphere = R3::MakeShape("sphere", {1, 2, 3, radius});
  Draw draw(95);
  for (int i = 0; i < 2000; ++i) {
    const R3::Vector d = draw.Direction();
    const R3::Ray ray{R3::Point{1, 2, 3} + 2 * draw.Direction() - draw.Scale(0, 3) * d, d};
    const auto hit = blob->Intersect(ray, 0), expected = sphere->Intersect(ray, 0);
    ASSERT_EQ(hit.has_value(), expected.has_value());
    if (!hit) continue;
    EXPECT_NEAR(hit->t, expected->t, 1e-11);
    EXPECT_NEAR(Dot(blob->At(ray, *hit, 0).normal, AsVector(sphere->At(ray, *expected, 0).normal)), 1, 1e-12);
  }
  const R3::Box box = blob->Bounds(0);
  EXPECT_NEAR(box.low.y, 2 - radius, 0.03);
  EXPECT_NEAR(box.high.z, 3 + radius, 0.03);
}

TEST(Blob, IsHitWhereItsFieldCrossesTheThreshold) {
  Draw draw(96);
  int crossings = 0;
  for (int i = 0; i < Count(200, 20'000); ++i) {
    const Numbers numbers = RandomBlob(draw);
    const auto blob = R3::MakeShape("blob", numbers);
    for (int k = 0; k < 10; ++k) {
      const R3::Ray ray = RayThroughBlobs(draw);
      const std::vector<double> found = crossings::Along(*blob, ray);
      crossings += static_cast<int>(found.size());
      ASSERT_EQ(Fault(numbers, ray, found, 500), "") << testing::PrintToString(numbers) << oracle::Hex(ray);
    }
  }
  EXPECT_GT(crossings, 500);
}

TEST(Blob, AGapOfAMillionthIsSeen) {
  // Between two equal balls the field is smallest in the middle, 2 (1 - 0.25)^3.
  const double middle = 2 * 0.421875;
  const auto blob = [](double threshold) {
    return R3::MakeShape("blob", {threshold, -0.5, 0, 0, 1, 1, 0.5, 0, 0, 1, 1});
  };
  const R3::Ray along{{-5, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(crossings::Along(*blob(middle * (1 + 1e-12)), along).size(), 4u);
  EXPECT_EQ(crossings::Along(*blob(middle * (1 - 1e-12)), along).size(), 2u);
  const std::vector<double> gap = crossings::Along(*blob(middle * (1 + 1e-12)), along);
  EXPECT_LT(gap[2] - gap[1], 4e-6);
  EXPECT_GT(gap[2] - gap[1], 1e-6);
}

TEST(Blob, AFieldBelowTheThresholdHasNoSurface) {
  EXPECT_TRUE(R3::MakeShape("blob", {1, 0, 0, 0, 1, 0.9})->IsDegenerate());
  EXPECT_TRUE(R3::MakeShape("blob", {1, 0, 0, 0, 1, 2, 0, 0, 0, 1, -1.5})->IsDegenerate());
  EXPECT_FALSE(R3::MakeShape("blob", {1, 0, 0, 0, 1, 0.9, 0.1, 0, 0, 1, 0.9})->IsDegenerate());
}

TEST(Blob, SmallBallsAreMetAsExactlyAsLargeOnes) {
  const auto blob = R3::MakeShape("blob", {0.5, 0, 0, 0, 1, 1, 3, 0, 0, 1e-6, 1});
  const double radius = 1e-6 * std::sqrt(1 - std::cbrt(0.5));
  Draw draw(97);
  for (int i = 0; i < 1000; ++i) {
    const R3::Vector d = draw.Direction();
    const R3::Ray ray{R3::Point{3, 0, 0} - draw.Scale(-5, 1) * d, d, R3::infinity * -1};
    const std::vector<double> found = crossings::Along(*blob, {ray.origin, ray.direction});
    int near = 0;
    for (const double t : found) near += std::abs(Length(ray.At(t) - R3::Point{3, 0, 0}) - radius) < 1e-14;
    EXPECT_EQ(near, 2);
  }
}

}  // namespace
