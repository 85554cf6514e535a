// Spheres, boxes, cylinders and cones of any proportions, seen from afar, near by, inside and on the surface, along
// their axis and across it. Oracle: the stretch of the line inside two copies of the solid, one smaller and one larger
// by the bar, in 113 bits. A hit must lie between the two copies, no ray that meets the smaller may miss, none that
// misses the larger may hit. If this fails, thin things get holes or hairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

using R3::unit_roundoff;

/// A stretch of a line; empty when leave < enter.
struct Stretch {
  Quad enter = -Quad(R3::infinity), leave = Quad(R3::infinity);

  bool IsEmpty() const { return !(enter <= leave); }
  void Keep(Quad from, Quad to) {
    if (from > enter) enter = from;
    if (to < leave) leave = to;
  }
  void KeepNothing() { Keep(1, -1); }
};

/// Keeps low <= o + t d <= high.
void KeepSlab(Stretch& stretch, Quad low, Quad high, Quad o, Quad d) {
  if (high < low) return stretch.KeepNothing();
  if (d == 0) {
    if (o < low || o > high) stretch.KeepNothing();
    return;
  }
  const Quad a = (low - o) / d, b = (high - o) / d;
  if (a < b)
    stretch.Keep(a, b);
  else
    stretch.Keep(b, a);
}

/// Keeps a t^2 - 2 b t + c <= 0, where a > 0.
void KeepBetweenRoots(Stretch& stretch, Quad a, Quad b, Quad c) {
  const Quad discriminant = b * b - a * c;
  if (discriminant < 0) return stretch.KeepNothing();
  const Quad q = b < 0 ? b - oracle::Sqrt(discriminant) : b + oracle::Sqrt(discriminant);
  if (q == 0) return stretch.Keep(0, 0);
  const Quad one = c / q, other = q / a;
  if (one < other)
    stretch.Keep(one, other);
  else
    stretch.Keep(other, one);
}

/// Keeps x^2 + z^2 <= (R0 + t R1)^2 with R0 + t R1 >= 0; R1 = 0 makes it a cylinder.
void KeepRound(Stretch& stretch, const oracle::Vector& o, const oracle::Vector& d, Quad R0, Quad R1) {
  const Quad a = d.x * d.x + d.z * d.z - R1 * R1, b = R0 * R1 - (o.x * d.x + o.z * d.z);
  const Quad c = o.x * o.x + o.z * o.z - R0 * R0;
  if (R1 > 0) stretch.Keep(-R0 / R1, Quad(R3::infinity));
  if (R1 < 0) stretch.Keep(-Quad(R3::infinity), -R0 / R1);
  if (a > 0) return KeepBetweenRoots(stretch, a, b, c);
  if (a == 0 && b == 0) {
    if (c > 0 || R0 < 0) stretch.KeepNothing();
    return;
  }
  // Steeper than the cone: inside it from the one root on its own side of the apex.
  const Quad root = oracle::Sqrt(b * b - a * c), q = b < 0 ? b - root : b + root;
  const Quad one = q == 0 ? Quad(0) : c / q, other = a < 0 ? q / a : one;
  if (R1 > 0) stretch.Keep(one > other ? one : other, Quad(R3::infinity));
  if (R1 < 0) stretch.Keep(-Quad(R3::infinity), one < other ? one : other);
}

struct Solid {
  std::string kind;
  std::vector<double> arguments;

  R3::Point Center() const {
    const auto& a = arguments;
    if (kind == "box") return {(a[0] + a[3]) / 2, (a[1] + a[4]) / 2, (a[2] + a[5]) / 2};
    return {a[0], a[1], a[2]};
  }
  double Size() const {
    const auto& a = arguments;
    if (kind == "box") return std::max({a[3] - a[0], a[4] - a[1], a[5] - a[2]});
    return kind == "sphere" ? a[3] : a[3] + a[4];
  }

  /// What of the line lies in the solid grown by `more` on all sides (shrunk when it is negative).
  Stretch Inside(const R3::Ray& ray, Quad more) const {
    const auto& a = arguments;
    const auto d = oracle::Of(ray.direction);
    Stretch stretch;
    if (kind == "box") {
      const auto o = oracle::Of(ray.origin);
      KeepSlab(stretch, a[0] - more, a[3] + more, o.x, d.x);
      KeepSlab(stretch, a[1] - more, a[4] + more, o.y, d.y);
      KeepSlab(stretch, a[2] - more, a[5] + more, o.z, d.z);
      return stretch;
    }
    const auto o = oracle::Of(ray.origin) - oracle::Of(Center());
    if (kind == "sphere") {
      const Quad r = a[3] + more;
      if (r < 0)
        stretch.KeepNothing();
      else
        KeepBetweenRoots(stretch, Dot(d, d), -Dot(o, d), Dot(o, o) - r * r);
      return stretch;
    }
    const Quad half = Quad(a[4]) / 2;
    KeepSlab(stretch, -half - more, half + more, o.y, d.y);
    if (kind == "cylinder") {
      if (a[3] + more < 0) stretch.KeepNothing();
      KeepRound(stretch, o, d, a[3] + more, 0);
    } else {
      const Quad slope = Quad(a[3]) / Quad(a[4]);
      KeepRound(stretch, o, d, slope * (half - o.y) + more * oracle::Sqrt(1 + slope * slope), -slope * d.y);
      if (more > 0) KeepRound(stretch, o, d, a[3] + more, 0);  // the flat cone's rim, where it would grow far outward
    }
    return stretch;
  }

  /// The bar of Shape::Intersect: `roundings` u (distance + size).
  void Check(const R3::Shape& shape, const R3::Ray& ray, double roundings) const {
    const double reach = std::max(Length(ray.origin - Center()), Size());
    const Quad bar = Quad(roundings * unit_roundoff) * reach;
    const Stretch larger = Inside(ray, bar), smaller = Inside(ray, -bar);
    const auto hit = shape.Intersect(ray, 0);
    const auto story = [&] {
      std::string text = kind;
      for (const double x : arguments) {
        std::array<char, 40> number{};
        std::snprintf(number.data(), number.size(), " %a", x);
        text += number.data();
      }
      return text + ": " + oracle::Hex(ray);
    };
    if (larger.IsEmpty() || larger.leave <= 0) {
      EXPECT_FALSE(hit) << "hit, but the ray passes by: " << story();
      return;
    }
    if (!hit) {
      EXPECT_TRUE(smaller.IsEmpty() || smaller.leave <= 0) << "a hole: " << story();
      return;
    }
    const Quad t = hit->t;
    const bool enters = t >= larger.enter && (smaller.IsEmpty() || t <= smaller.enter);
    const bool leaves = t <= larger.leave && (smaller.IsEmpty() || t >= smaller.leave);
    EXPECT_TRUE(enters || leaves) << "off the surface: " << story() << " t " << hit->t;
    EXPECT_TRUE(enters || larger.enter <= 0) << "the way in was passed over: " << story() << " t " << hit->t;
  }
};

/// A solid of the given proportions around a center as far from the origin as `center` sizes.
Solid MakeSolid(Draw& draw, const std::string& kind, double radius, double height, double center) {
  const R3::Point c = R3::Point{} + center * std::max(radius, height) * draw.Direction();
  if (kind == "sphere") return {kind, {c.x, c.y, c.z, radius}};
  if (kind == "box")
    return {kind, {c.x - radius, c.y - height / 2, c.z - radius, c.x + radius, c.y + height / 2, c.z + radius}};
  return {kind, {c.x, c.y, c.z, radius, height}};
}

/// From anywhere (inside, near, far) towards the neighborhood of the solid; now and then in a plane or along an axis.
R3::Ray RayNear(Draw& draw, const Solid& solid, double radius, double height) {
  const auto around = [&](double share) {
    return solid.Center() + R3::Vector{radius * draw.Between(-share, share), height / 2 * draw.Between(-share, share),
                                       radius * draw.Between(-share, share)};
  };
  const R3::Point target = around(1.1);
  const R3::Point origin =
      draw.Whole(0, 2) == 0 ? around(2) : solid.Center() + draw.Scale(-1, 6) * solid.Size() * draw.Direction();
  R3::Vector d = target - origin;
  switch (draw.Whole(0, 9)) {
    case 0:
      d.x = 0;
      break;
    case 1:
      d.y = 0;
      break;
    case 2:
      d.z = -0.0;
      break;
    case 3:
      d = {0, d.y, 0};
      break;
    case 4:
      d = {d.x * 1e-9, d.y, d.z * 1e-9};
      break;  // almost along the axis
    case 5:
      d = {d.x, d.y * 1e-9, d.z};
      break;  // almost across it
    default:
      break;
  }
  return {origin, draw.Scale(-3, 3) * d};
}

TEST(Extremes, EverySolidOfAnyProportionsHasNeitherHolesNorHairs) {
  Draw draw(801);
  for (const std::string kind : {"sphere", "box", "cylinder", "cone"})
    for (int i = 0; i < Count(3'000, 300'000); ++i) {
      const double radius = draw.Scale(-6, 6), height = i % 2 ? radius * draw.Scale(-1, 1) : draw.Scale(-6, 6);
      const Solid solid = MakeSolid(draw, kind, radius, height, i % 3);
      const auto shape = R3::MakeShape(kind, solid.arguments);
      for (int k = 0; k < 20; ++k)
        solid.Check(*shape, RayNear(draw, solid, radius, height), kind == "sphere" || kind == "box" ? 8 : 32);
    }
}

TEST(Extremes, C1_OnTheLatticeTheBoxShapeIsHitExactlyWhereWholeNumbersSay) {
  Draw draw(805);
  for (int i = 0; i < Count(300'000, 100'000'000); ++i) {
    const auto whole = [&] { return static_cast<double>(draw.Whole(-5, 5)); };
    Solid box{"box", {}};
    for (int k = 0; k < 6; ++k) box.arguments.push_back(whole());
    if (i % 4 == 0) box.arguments[3] = box.arguments[0];  // flat
    for (std::size_t k = 0; k < 3; ++k)
      if (box.arguments[k] > box.arguments[k + 3]) std::swap(box.arguments[k], box.arguments[k + 3]);
    const auto shape = R3::MakeShape("box", box.arguments);
    if (shape->IsDegenerate()) continue;
    const auto component = [&] { return draw.Whole(0, 1) ? whole() : draw.Whole(0, 1) ? 0.0 : -0.0; };
    const R3::Ray ray{{whole(), whole(), whole()}, {component(), component(), component()}};
    if (ray.direction == R3::Vector{}) continue;
    // Quotients of such small whole numbers are equal or far apart, so that 113 bits compare them exactly. A ray that
    // starts on the box and leaves it at once does not hit it.
    const Stretch truth = box.Inside(ray, 0);
    const Quad t = truth.enter > 0 ? truth.enter : truth.leave;
    const auto hit = shape->Intersect(ray, 0);
    ASSERT_EQ(hit.has_value(), !truth.IsEmpty() && truth.leave > 0) << oracle::Hex(ray);
    if (hit) {
      ASSERT_EQ(hit->t, oracle::Double(t)) << oracle::Hex(ray);
    }
  }
}

TEST(Extremes, B4_AWireAndACoinAreHitAlongTheirAxisToo) {
  Draw draw(802);
  for (const auto& [radius, height] : {std::pair{1e-6, 1e6}, {1e6, 1e-6}, {1e-6, 1e-6}, {1e6, 1e6}, {1e-6, 1.0}}) {
    const Solid solid = MakeSolid(draw, "cylinder", radius, height, 0);
    const auto shape = R3::MakeShape("cylinder", solid.arguments);
    for (int power = 2; power <= 14; ++power)
      for (int i = 0; i < Count(400, 40'000); ++i) {
        // At an angle of 10^-power with the axis, from inside the round and from all around.
        const double turn = draw.Between(0, 6.28), angle = std::pow(10, -power);
        const R3::Vector along{angle * std::cos(turn), draw.Whole(0, 1) ? 1.0 : -1.0, angle * std::sin(turn)};
        const double y = draw.Whole(0, 1) ? height * draw.Between(-0.6, 0.6) : height * draw.Scale(0, 3);
        const R3::Point origin{radius * draw.Between(-1.1, 1.1), along.y > 0 ? -y : y,
                               radius * draw.Between(-1.1, 1.1)};
        solid.Check(*shape, {origin, along}, 32);
      }
  }
}

TEST(Extremes, B4_ARayParallelToTheAxisMeetsOnlyTheEnds) {
  const auto cylinder = R3::MakeShape("cylinder", {0, 0, 0, 1, 2});
  Draw draw(803);
  for (int i = 0; i < 2'000; ++i) {
    const double r = draw.Between(0, 1), turn = draw.Between(0, 6.28);
    const R3::Ray down{{r * std::cos(turn), 3, r * std::sin(turn)}, {0, -1, 0}};
    const auto top = cylinder->Intersect(down, 0);
    ASSERT_TRUE(top) << oracle::Hex(down);
    EXPECT_EQ(top->t, 2);
    EXPECT_EQ(cylinder->At(down, *top, 0).normal, (R3::Normal{0, 1, 0}));
    const auto bottom = cylinder->Intersect({down.origin, down.direction, top->t}, 0);
    ASSERT_TRUE(bottom) << oracle::Hex(down);
    EXPECT_EQ(bottom->t, 4);
    EXPECT_EQ(cylinder->At(down, *bottom, 0).normal, (R3::Normal{0, -1, 0}));
  }
}

TEST(Extremes, B5_NeedlesAndPlatesSeenThroughTheirApexOrAlongTheirSideHaveNoHoles) {
  Draw draw(804);
  for (int k = 0; k <= 8; ++k)
    for (const bool is_needle : {true, false}) {
      const double thin = std::pow(10, -k), radius = is_needle ? thin : 1, height = is_needle ? 1 : thin;
      const Solid solid = MakeSolid(draw, "cone", radius, height, 0);
      const auto shape = R3::MakeShape("cone", solid.arguments);
      for (int i = 0; i < Count(2'000, 200'000); ++i) {
        const double turn = draw.Between(0, 6.28), aside = draw.Between(0.5, 1.5);
        const R3::Point apex{0, height / 2, 0};
        // A generator line, or one beside it, run along from either end, or met at a small angle.
        R3::Vector side{aside * radius * std::cos(turn), -height, aside * radius * std::sin(turn)};
        if (i % 2) side = side + draw.Scale(-12, -1) * solid.Size() * draw.Direction();
        const double start = draw.Between(-3, 3);
        solid.Check(*shape, {apex + start * side, draw.Whole(0, 1) ? side : -side}, 32);
        const R3::Point origin = apex + draw.Scale(-2, 3) * draw.Direction();
        solid.Check(*shape, {origin, apex - origin}, 32);
      }
    }
}

}  // namespace
