#include "R3/Warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <vector>

#include "source/sample/Random.h"
#include "tests/ChiSquare.h"

namespace {

constexpr double pi = std::numbers::pi;
constexpr int points = 1'000'000;
constexpr int tests = 12;  // that share a chance of 1 % to fail although all is well
constexpr double largest_random = 1 - 0x1p-53;
constexpr double exponents[] = {0, 1, 10, 1000, 1e6};
constexpr double cones[] = {1e-12, 0.25, 2};  // one minus the cosine

R2::Point Random(int i) {
  const ray::RandomKey key = ray::RandomKey(7).Child(static_cast<std::uint64_t>(i));
  return {key.Child(0).Number(), key.Child(1).Number()};
}

int Slice(double x, int slices) { return std::clamp(static_cast<int>(x * slices), 0, slices - 1); }

double Turns(double x, double y) {
  const double turns = std::atan2(y, x) / (2 * pi);
  return turns < 0 ? turns + 1 : turns;
}

// Uses 16 x 16 cells; `place` returns the position of a point in the unit square, so that even points fill it evenly.
double OverQuantile(const std::function<R2::Point(const R2::Point&)>& place) {
  std::vector<double> counts(256);
  for (int i = 0; i < points; ++i) {
    const R2::Point at = place(Random(i));
    ++counts[static_cast<std::size_t>(16 * Slice(at.x, 16) + Slice(at.y, 16))];
  }
  return chi_square::OverQuantile(counts, std::vector<double>(256, 1.0 / 256), 0.01 / tests);
}

// Returns the share of the sphere's points whose cosine with +z is between two values, by the midpoint rule over the
// pdf.
double Share(const std::function<double(double)>& pdf, double low, double high) {
  constexpr int steps = 20'000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += pdf(low + (high - low) * (i + 0.5) / steps);
  return 2 * pi * (high - low) * sum / steps;
}

std::vector<R2::Point> Extremes() {
  std::vector<R2::Point> extremes;
  for (const double x : {0.0, 0x1p-53, 0.25, 0.5, 0.75, largest_random, 1.0})
    for (const double y : {0.0, 0x1p-53, 0.25, 0.5, 0.75, largest_random, 1.0}) extremes.push_back({x, y});
  for (int i = 0; i < 10'000; ++i) extremes.push_back(Random(i));
  return extremes;
}

TEST(Extremes, I3_TheDiscIsCoveredEvenly) {
  EXPECT_LT(OverQuantile([](const R2::Point& u) {
              const R2::Point p = R3::SampleUniformDiskConcentric(u);
              return R2::Point{p.x * p.x + p.y * p.y, Turns(p.x, p.y)};
            }),
            1);
}

TEST(Extremes, I3_TheTriangleIsCoveredEvenly) {
  // 16 rows along the side opposite to corner 2 divide the triangle into 256 equal ones.
  std::vector<double> counts(256);
  for (int i = 0; i < points; ++i) {
    const auto barycentric = R3::SampleUniformTriangle(Random(i));
    const R2::Point p{barycentric[1], barycentric[2]};
    const int row = Slice(p.y, 16), column = Slice(p.x, 16);
    const bool is_upper = p.x * 16 - column + p.y * 16 - row > 1;
    // A row of k upright triangles and k - 1 upside-down ones: (16 - row) and (15 - row).
    const int before = 256 - (16 - row) * (16 - row);
    ++counts[static_cast<std::size_t>(std::clamp(before + 2 * column + is_upper, 0, 255))];
  }
  EXPECT_LT(chi_square::OverQuantile(counts, std::vector<double>(256, 1.0 / 256), 0.01 / tests), 1);
}

TEST(Extremes, I3_TheHemisphereIsCoveredByTheCosine) {
  EXPECT_LT(OverQuantile([](const R2::Point& u) {
              const R3::Vector d = R3::SampleCosineHemisphere(u);
              return R2::Point{1 - d.z * d.z, Turns(d.x, d.y)};
            }),
            1);
  // The stated pdf also gives these rings equal shares.
  for (int k = 0; k < 16; ++k)
    EXPECT_NEAR(Share(R3::CosineHemispherePdf, std::sqrt(k / 16.0), std::sqrt((k + 1) / 16.0)), 1.0 / 16, 1e-6);
  EXPECT_NEAR(Share(R3::CosineHemispherePdf, -1, 1), 1, 1e-4);
}

TEST(Extremes, I3_PhongsLobeIsCoveredByThePowerOfTheCosine) {
  for (const double n : exponents) {
    EXPECT_LT(OverQuantile([&](const R2::Point& u) {
                const R3::Vector d = R3::SamplePhongLobe(u, n);
                const double square_of_sine = d.x * d.x + d.y * d.y;
                return R2::Point{std::exp(0.5 * (n + 1) * std::log1p(-std::min(square_of_sine, largest_random))),
                                 Turns(d.x, d.y)};
              }),
              1)
        << n;
    const auto pdf = [&](double cosine) { return R3::PhongLobePdf(cosine, n); };
    const auto ring = [&](double share) { return std::pow(share, 1 / (n + 1)); };
    double all = Share(pdf, 0, ring(1e-6));
    for (int k = 0; k < 16; ++k) {
      const double share = Share(pdf, ring(std::max(1e-6, k / 16.0)), ring((k + 1) / 16.0));
      EXPECT_NEAR(share, 1.0 / 16, 2e-6) << n << " ring " << k;
      all += share;
    }
    EXPECT_NEAR(all, 1, 1e-4) << n;
    EXPECT_EQ(R3::PhongLobePdf(-0.5, n), 0);
  }
}

TEST(Extremes, I3_TheSphereIsCoveredEvenly) {
  EXPECT_LT(OverQuantile([](const R2::Point& u) {
              const R3::Vector d = R3::SampleUniformSphere(u);
              return R2::Point{(1 - d.z) / 2, Turns(d.x, d.y)};
            }),
            1);
  EXPECT_NEAR(Share([](double) { return R3::uniform_sphere_pdf; }, -1, 1), 1, 1e-12);
}

TEST(Extremes, I3_ConesAreCoveredEvenlyHoweverNarrow) {
  for (const double c : cones) {
    EXPECT_LT(OverQuantile([&](const R2::Point& u) {
                const R3::Vector d = R3::SampleUniformCone(u, c);
                // 1 - z, which has no digits left in a narrow cone, computed from the sine.
                const double square_of_sine = d.x * d.x + d.y * d.y;
                const double height = d.z > 0 ? square_of_sine / (1 + d.z) : 1 - d.z;
                return R2::Point{height / c, Turns(d.x, d.y)};
              }),
              1)
        << c;
    EXPECT_NEAR(2 * pi * c * R3::UniformConePdf(c), 1, 1e-14) << c;
  }
}

TEST(Warp, DirectionsAreUnitEvenAtTheSquaresEdges) {
  const R3::Vector abouts[] = {{0, 0, 1}, {0, 0, -1}, {0, 0.6, -0.8}, {1, 0, -0.0}, Unit(R3::Vector{1e-9, 2e-9, -1})};
  for (const R2::Point& u : Extremes()) {
    std::vector<R3::Vector> directions{R3::SampleCosineHemisphere(u), R3::SampleUniformSphere(u)};
    for (const double n : exponents) directions.push_back(R3::SamplePhongLobe(u, n));
    for (const double c : cones) directions.push_back(R3::SampleUniformCone(u, c));
    directions.push_back(R3::SampleUniformCone(u, 0));
    for (const R3::Vector& d : directions) {
      ASSERT_NEAR(Length(d), 1, 1e-14) << u.x << " " << u.y;
      for (const R3::Vector& about : abouts) {
        const R3::Vector turned = R3::FromTangents(d, about);
        ASSERT_NEAR(Length(turned), 1, 1e-14) << u.x << " " << u.y;
        ASSERT_NEAR(Dot(turned, about), d.z, 1e-14);
      }
    }
    for (const double n : exponents) {
      const R3::Vector d = R3::SamplePhongLobe(u, n);
      ASSERT_GE(d.z, 0);
      ASSERT_TRUE(std::isfinite(R3::PhongLobePdf(d.z, n))) << n;
    }
    ASSERT_GE(R3::SampleCosineHemisphere(u).z, 0);
    const R2::Point disc = R3::SampleUniformDiskConcentric(u);
    const auto triangle = R3::SampleUniformTriangle(u);
    ASSERT_LE(std::hypot(disc.x, disc.y), 1 + 1e-15);
    for (const double coordinate : triangle) ASSERT_GE(coordinate, 0);
    ASSERT_LE(triangle[1] + triangle[2], 1 + 0x1p-52);
    ASSERT_NEAR(triangle[0] + triangle[1] + triangle[2], 1, 0x1p-52);
  }
}

TEST(Warp, TangentsMakeARightHandedFrame) {
  for (int i = 0; i < 10'000; ++i) {
    const R3::Vector n = R3::SampleUniformSphere(Random(i));
    const R3::Tangents t = R3::TangentsOf(n);
    ASSERT_NEAR(Length(Cross(t.first, t.second) - n), 0, 4e-15);
  }
}

}  // namespace
