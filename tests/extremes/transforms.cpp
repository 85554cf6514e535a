// Scales from 1e-30 to 1e30, mirrors, singular matrices, and chains of 100,000.

#include <gtest/gtest.h>

#include <numbers>

#include "R3/Mesh.h"
#include "R3/ShapeKind.h"
#include "R3/Transform.h"
#include "source/scene/Singular.h"
#include "tests/BoundedShapes.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

using R3::unit_roundoff;

R3::Matrix Diagonal(double x, double y, double z) {
  R3::Matrix m;
  m.m = {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}};
  return m;
}

R3::Ray RayTowards(Draw& draw, const R3::Shape& shape) {
  const R3::Box box = Bounds(shape);
  const R3::Point origin = box.Center() + 5 * box.Radius() * draw.Direction();
  const R3::Vector size = box.Size();
  const R3::Point target =
      box.low + R3::Vector{size.x * draw.Between(0, 1), size.y * draw.Between(0, 1), size.z * draw.Between(0, 1)};
  return {origin, target - origin};
}

TEST(Extremes, A1_PowersOfTwoScaleEveryHitBitForBit) {
  for (const auto* kind : BoundedShapeKinds()) {
    const auto shape = kind->make(kind->example);
    Draw draw(11);
    for (int i = 0; i < 2000; ++i) {
      const R3::Ray ray = RayTowards(draw, *shape);
      const auto plain = shape->Intersect(ray, 0);
      for (const int power : {-100, -50, -1, 1, 50, 100}) {
        const double s = std::scalbn(1.0, power);
        const auto transform = R3::Transform::Of(Diagonal(s, s, s));
        ASSERT_TRUE(transform);
        const R3::Ray scaled{R3::Point{} + s * FromOrigin(ray.origin), ray.direction};
        const auto hit = shape->Intersect(transform->Back(scaled), 0);
        ASSERT_EQ(hit.has_value(), plain.has_value()) << kind->name << ' ' << oracle::Hex(ray);
        EXPECT_EQ(hit ? hit->t : 0, plain ? plain->t * s : 0) << kind->name << ' ' << oracle::Hex(ray);
      }
    }
  }
}

TEST(Extremes, A1_PowersOfTenScaleEveryHitWithinRounding) {
  for (const auto* kind : BoundedShapeKinds()) {
    const auto shape = kind->make(kind->example);
    Draw draw(12);
    for (int i = 0; i < 1000; ++i) {
      const R3::Ray ray = RayTowards(draw, *shape);
      const auto plain = shape->Intersect(ray, 0);
      if (!plain) continue;
      // How much t moves when the ray moves sideways by its own rounding: the condition of the hit.
      const auto at = shape->At(ray, *plain, 0);
      const double cosine = std::abs(Dot(at.normal, Unit(ray.direction)));
      if (cosine < 0.01) continue;
      for (const int power : {-30, -20, -15, -10, -6, -3, 3, 6, 10, 15, 20, 30}) {
        const double s = std::pow(10, power);
        const auto transform = R3::Transform::Of(Diagonal(s, s, s));
        ASSERT_TRUE(transform);
        const R3::Ray scaled{R3::Point{} + s * FromOrigin(ray.origin), ray.direction};
        const auto hit = shape->Intersect(transform->Back(scaled), 0);
        ASSERT_TRUE(hit) << kind->name << ' ' << oracle::Hex(ray);
        EXPECT_LE(std::abs(hit->t / (plain->t * s) - 1), 16 * unit_roundoff / cosine) << kind->name << ' ' << power;
      }
    }
  }
}

TEST(Extremes, A2_NormalsTransformByTheInverseTranspose) {
  Draw draw(20);
  for (const auto& [x, y, z] : {std::array{1.0, 1e-3, 1e3}, std::array{1e6, 1.0, 1e-6}}) {
    const auto transform = R3::Transform::Of(Diagonal(x, y, z));
    ASSERT_TRUE(transform);
    for (int i = 0; i < 10'000; ++i) {
      const R3::Vector n = draw.Direction();
      const R3::Normal got = *transform * AsNormal(n);
      oracle::Vector truth{Quad(n.x) / Quad(x), Quad(n.y) / Quad(y), Quad(n.z) / Quad(z)};
      truth = 1 / oracle::Length(truth) * truth;
      EXPECT_LE(oracle::Double(oracle::Length(oracle::Of(AsVector(got)) - truth)), 8 * unit_roundoff);
      EXPECT_LE(std::abs(Length(AsVector(got)) - 1), 4 * unit_roundoff);
    }
  }
}

TEST(Extremes, A3_EverySignPatternMirrorsHitsExactlyAndKeepsNormalsOutward) {
  for (const auto* kind : BoundedShapeKinds()) {
    const auto shape = kind->make(kind->example);
    Draw draw(30);
    for (int i = 0; i < 500; ++i) {
      const R3::Ray ray = RayTowards(draw, *shape);
      const auto plain = shape->Intersect(ray, 0);
      const double side = crossings::Count(*shape, ray) % 2 == 0 ? -1 : 1;  // normals face rays from outside
      for (int signs = 1; signs < 8; ++signs) {
        const double x = signs & 1 ? -1 : 1, y = signs & 2 ? -1 : 1, z = signs & 4 ? -1 : 1;
        const auto mirror = R3::Transform::Of(Diagonal(x, y, z));
        ASSERT_TRUE(mirror);
        EXPECT_EQ(mirror->Mirrors(), x * y * z < 0);
        const R3::Ray mirrored{*mirror * ray.origin, *mirror * ray.direction};
        const auto hit = shape->Intersect(mirror->Back(mirrored), 0);
        ASSERT_EQ(hit.has_value(), plain.has_value());
        if (!hit) continue;
        EXPECT_EQ(hit->t, plain->t);
        const auto at = shape->At(mirror->Back(mirrored), *hit, 0);
        const R3::Vector outward = AsVector(*mirror * at.normal);
        EXPECT_TRUE(!shape->IsSolid() || side * Dot(outward, mirrored.direction) > 0) << kind->name << ' ' << signs;
      }
    }
  }
}

TEST(Extremes, A6_SingularMatricesAreRecognizedAndNothingElseIs) {
  for (const auto& m :
       {Diagonal(0, 1, 1), Diagonal(1, 0, 1), Diagonal(1, 1, 0), Diagonal(0, 0, 0), Diagonal(1, 1e-16, 1)}) {
    EXPECT_TRUE(ray::IsSingular(m));
    EXPECT_FALSE(ray::IsSingular(Diagonal(1e-30, 1e-30, 1e-30)));
  }
  R3::Matrix dependent = Diagonal(1, 1, 1);
  dependent.m[2] = {1, 1, 0, 0};  // the sum of the other two rows
  EXPECT_TRUE(ray::IsSingular(dependent));
  for (int power = 1; power <= 14; ++power)
    EXPECT_FALSE(ray::IsSingular(Diagonal(1, std::pow(10, -power), 1))) << power;
  for (const double huge : {1e120, 1e-120}) EXPECT_FALSE(ray::IsSingular(Diagonal(huge, huge, huge)));
  EXPECT_FALSE(R3::Transform::Of(Diagonal(R3::infinity, 1, 1)));
  EXPECT_FALSE(R3::Transform::Of(Diagonal(std::nan(""), 1, 1)));
}

/// The product of a chain in 113 bits.
struct WideMatrix {
  Quad m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  void Append(const R3::Matrix& next) {
    Quad r[3][4];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        r[i][j] = j == 3 ? m[i][3] : Quad(0);
        for (std::size_t k = 0; k < 3; ++k) r[i][j] += m[i][k] * Quad(next.m[k][j]);
      }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) m[i][j] = r[i][j];
  }

  oracle::Vector operator*(const R3::Point& p) const {
    const auto row = [&](int i) { return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3]; };
    return {row(0), row(1), row(2)};
  }
};

TEST(Extremes, A10_AChainOfAHundredThousandTransformsLosesNothing) {
  Draw draw(100);
  R3::Product product;
  WideMatrix truth;
  const R3::Point p{0.3, -0.7, 0.5};
  for (int level = 1; level <= 100'000; ++level) {
    R3::Matrix m = draw.Rotation();
    const double scale = draw.Whole(0, 1) ? 2.0 / 3 : 3.0 / 2;
    for (auto& row : m.m)
      for (std::size_t j = 0; j < 3; ++j) row[j] *= scale;
    product = product * m;
    truth.Append(m);
    if (level != 1 && level != 10 && level != 100 && level != 1000 && level != 10'000 && level != 100'000) continue;
    const auto transform = R3::Transform::Of(product);
    ASSERT_TRUE(transform) << level;
    const oracle::Vector exact = truth * p;
    const oracle::Vector error = oracle::Of(*transform * p) - exact;
    EXPECT_LE(oracle::Double(oracle::Length(error) / oracle::Length(exact)), 8 * unit_roundoff) << level;
    // And back again.
    const R3::Point there_and_back = transform->Inverse() * (*transform * p);
    EXPECT_LE(Length(there_and_back - p), 32 * unit_roundoff) << level;
  }
}

TEST(Transform, InversesOfIllConditionedMatricesAreCorrectlyRounded) {
  Draw draw(40);
  for (int i = 0; i < 2000; ++i) {
    // Two rotations around a squeeze: condition up to 1e12.
    const R3::Matrix a = draw.Rotation(), b = draw.Rotation();
    const auto transform =
        R3::Transform::Of(R3::Product() * a * Diagonal(1, draw.Scale(-6, 0), draw.Scale(-12, 0)) * b);
    ASSERT_TRUE(transform);
    // inverse * forward, in 113 bits, must be the identity but for the rounding of the two factors' entries.
    const auto &f = transform->Forward().m, &g = transform->Inverse().m;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        Quad sum = 0, magnitude = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          sum += Quad(g[r][k]) * Quad(f[k][c]);
          magnitude += oracle::Abs(Quad(g[r][k]) * Quad(f[k][c]));
        }
        EXPECT_LE(oracle::Double(oracle::Abs(sum - (r == c ? 1 : 0)) / magnitude), 2.5 * unit_roundoff);
      }
  }
}

/// The largest entry of inverse * forward - 1, in 113 bits, as a share of the condition: the product of both norms.
double InverseError(const R3::Transform& t) {
  Quad worst = 0, forward_square = 0, inverse_square = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Quad entry = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) entry += Quad(t.Inverse().m[i][k]) * t.Forward().m[k][j];
      worst = std::max(worst, oracle::Abs(entry));
      forward_square += Quad(t.Forward().m[i][j]) * t.Forward().m[i][j];
      inverse_square += Quad(t.Inverse().m[i][j]) * t.Inverse().m[i][j];
    }
  return oracle::Double(worst / oracle::Sqrt(forward_square * inverse_square));
}

TEST(Extremes, A4_InversesUndoShearsAndTinyOrManyTurns) {
  const auto expect_undone = [](const R3::Matrix& m, const std::string& what) {
    const auto transform = R3::Transform::Of(m);
    ASSERT_TRUE(transform) << what;
    EXPECT_LE(InverseError(*transform), 1e-15) << what;
  };
  for (const double shear : {1e3, 1e6})
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (i == j) continue;
        R3::Matrix m;
        m.m[i][j] = shear;
        expect_undone(m, "a shear by " + std::to_string(shear));
      }
  Draw draw(44);
  for (const double angle : {1e-8, 1e6 * 2 * std::numbers::pi + 0.3})
    for (int i = 0; i < 100; ++i) {
      const R3::Vector axis = draw.Direction();
      const R3::Vector x = Turned({1, 0, 0}, axis, angle), y = Turned({0, 1, 0}, axis, angle),
                       z = Turned({0, 0, 1}, axis, angle);
      R3::Matrix m;
      m.m = {{{x.x, y.x, z.x, 1e3}, {x.y, y.y, z.y, -1}, {x.z, y.z, z.z, 0}}};
      expect_undone(m, "a turn by " + std::to_string(angle));
    }
}

}  // namespace
