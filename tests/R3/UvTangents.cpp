#include "R3/UvTangents.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"

namespace {

/// A shape that does not define its tangents.
class Silent : public R3::Shape {
 public:
  explicit Silent(const R3::Shape& shape) : shape_(shape) {}

  R3::Box Bounds(int element) const override { return shape_.Bounds(element); }
  std::optional<R3::Hit> Intersect(const R3::Ray& ray, int element) const override {
    return shape_.Intersect(ray, element);
  }
  R3::Intersection At(const R3::Ray& ray, const R3::Hit& hit, int element) const override {
    return shape_.At(ray, hit, element);
  }
  bool IsBounded() const override { return shape_.IsBounded(); }

 private:
  const R3::Shape& shape_;
};

/// The gradient of a coordinate over the surface, on which both descriptions must agree.
R3::Vector Gradient(const R3::UvTangents& uv, const R3::Vector& n, double R2::Vector::*coordinate) {
  const R3::Vector sum =
      uv.gain_first.*coordinate * Cross(uv.second, n) + uv.gain_second.*coordinate * Cross(n, uv.first);
  return sum / Dot(n, Cross(uv.first, uv.second));
}

R3::UvTangents FoundByRays(const char* kind, std::vector<double> arguments, const R3::Ray& ray) {
  const auto shape = R3::FindShapeKind(kind)->make(arguments);
  const auto hit = shape->Intersect(ray, 0);
  return Silent(*shape).UvTangentsAt(ray, *hit, 0);
}

// u falls from 1 to 0 there, over 2 pi to a turn.
TEST(UvTangents, FoundByRaysRunOverTheSeamOfATexture) {
  const R3::UvTangents uv = FoundByRays("sphere", {0, 0, 0, 1}, {{1e-9, 5, 0}, {0, -1, 0}});
  const R3::Vector gradient = Gradient(uv, {0, 1, 0}, &R2::Vector::x);
  EXPECT_LT(Length(gradient - R3::Vector{1 / (2 * std::numbers::pi), 0, 0}), 1e-8);
}

// v runs from 0 to 1 over the height of 2; above the rim there is nothing.
TEST(UvTangents, FoundByRaysAreOneSidedAtAnEdge) {
  const R3::UvTangents uv = FoundByRays("cylinder", {0, 0, 0, 1, 2}, {{5, 1 - 1e-9, 0}, {-1, 0, 0}});
  EXPECT_LT(Length(Gradient(uv, {1, 0, 0}, &R2::Vector::y) - R3::Vector{0, 0.5, 0}), 1e-8);
}

/// Two planes that meet in the y axis, each falling by a quarter, with u along x; on the right one 1/4 more.
class Roof : public R3::Shape {
 public:
  R3::Box Bounds(int) const override { return {{-1, -1, -0.25}, {1, 1, 0}}; }
  std::optional<R3::Hit> Intersect(const R3::Ray& ray, int) const override {
    for (const int part : {0, 1}) {
      const R3::Vector n = AsVector(NormalOf(part));
      const double t = -Dot(n, FromOrigin(ray.origin)) / Dot(n, ray.direction);
      if (t > ray.t_min && t < ray.t_max && (ray.At(t).x > 0) == (part == 1)) return R3::Hit{.t = t, .part = part};
    }
    return {};
  }
  R3::Intersection At(const R3::Ray& ray, const R3::Hit& hit, int) const override {
    const R3::Point p = ray.At(hit.t);
    return {{p, NormalOf(hit.part), NormalOf(hit.part), {p.x + 0.25 * hit.part, p.y}, {}}, {}};
  }

 private:
  static R3::Normal NormalOf(int part) { return AsNormal(Unit(R3::Vector{part == 1 ? 0.25 : -0.25, 0, 1})); }
};

TEST(UvTangents, FoundByRaysBelongToThePartHit) {
  const Roof roof;
  const R3::Ray ray{{1e-9, 0, 1}, {0, 0, -1}};
  const auto hit = roof.Intersect(ray, 0);
  const R3::UvTangents uv = roof.UvTangentsAt(ray, *hit, 0);
  const R3::Vector n = AsVector(roof.At(ray, *hit, 0).normal);
  EXPECT_LT(Length(Gradient(uv, n, &R2::Vector::x) - R3::Vector{16, 0, -4} / 17), 1e-8);
}

// CONTRIBUTING promises that a new shape need not define them.
TEST(UvTangents, AreFoundByRaysIfAShapeGivesNone) {
  for (const auto* kind : AllShapeKinds()) {
    const auto shape = kind->make(kind->example);
    const Silent silent(*shape);
    Draw draw(811);
    int compared = 0;
    for (int i = 0; i < Count(1000, 100'000); ++i) {
      const R3::Point target{draw.Between(-1, 1), draw.Between(-1, 1), draw.Between(0, 2)};
      const R3::Vector way = draw.Direction();
      const R3::Ray ray{target - 5 * way, way};
      const auto hit = shape->Intersect(ray, 0);
      if (!hit) continue;
      const R3::Vector n = AsVector(shape->At(ray, *hit, 0).normal);
      const R3::UvTangents derivatives = shape->UvTangentsAt(ray, *hit, 0), found = silent.UvTangentsAt(ray, *hit, 0);
      for (const auto coordinate : {&R2::Vector::x, &R2::Vector::y}) {
        const R3::Vector right = Gradient(derivatives, n, coordinate);
        if (!(Length(right) < 2)) continue;  // near a pole or an apex, curves are as short as the steps
        // Next to an edge only one side is found.
        EXPECT_LT(Length(Gradient(found, n, coordinate) - right), 2e-4) << kind->name << ' ' << i;
        ++compared;
      }
    }
    EXPECT_GT(compared, 100) << kind->name;
  }
}

}  // namespace
