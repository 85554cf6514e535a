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
#include "tests/ExactSolid.h"

namespace {

using oracle::Solid;
using R3::unit_roundoff;

/// The bar of Shape::Intersect: `roundings` u (distance + size).
void Check(const Solid& solid, const R3::Shape& shape, const R3::Ray& ray, double roundings) {
  const double reach = std::max(Length(ray.origin - solid.Center()), solid.Size());
  const Quad bar = Quad(roundings * unit_roundoff) * reach;
  const oracle::Stretch larger = solid.Inside(oracle::Of(ray), bar), smaller = solid.Inside(oracle::Of(ray), -bar);
  const auto hit = shape.Intersect(ray, 0);
  const auto story = [&] {
    std::string text = solid.kind;
    for (const double x : solid.arguments) {
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
  for (const std::string kind : {"sphere", "box", "cylinder", "cone", "paraboloid"})
    for (int i = 0; i < Count(3'000, 300'000); ++i) {
      const double radius = draw.Scale(-6, 6), height = i % 2 ? radius * draw.Scale(-1, 1) : draw.Scale(-6, 6);
      const Solid solid = MakeSolid(draw, kind, radius, height, i % 3);
      const auto shape = R3::MakeShape(kind, solid.arguments);
      for (int k = 0; k < 20; ++k)
        Check(solid, *shape, RayNear(draw, solid, radius, height), kind == "sphere" || kind == "box" ? 8 : 32);
    }
}

TEST(Extremes, C1_BoxesOnALatticeAreHitExactly) {
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
    const oracle::Stretch truth = box.Inside(oracle::Of(ray), 0);
    const Quad t = truth.enter > 0 ? truth.enter : truth.leave;
    const auto hit = shape->Intersect(ray, 0);
    ASSERT_EQ(hit.has_value(), !truth.IsEmpty() && truth.leave > 0) << oracle::Hex(ray);
    if (hit) {
      ASSERT_EQ(hit->t, oracle::Double(t)) << oracle::Hex(ray);
    }
  }
}

TEST(Extremes, B4_WiresAndCoinsAreHitAlongTheirAxis) {
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
        Check(solid, *shape, {origin, along}, 32);
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

TEST(Extremes, B5_NeedleAndPlateConesHaveNoHoles) {
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
        Check(solid, *shape, {apex + start * side, draw.Whole(0, 1) ? side : -side}, 32);
        const R3::Point origin = apex + draw.Scale(-2, 3) * draw.Direction();
        Check(solid, *shape, {origin, apex - origin}, 32);
      }
    }
}

// Almost along a side the form's slope is nothing but rounding: Newton's step by it goes anywhere. One ray in 10^5 of
// those above tells.
TEST(Extremes, B5_ARayAlongASideIsNotMovedByRounding) {
  const Solid cone{"cone", {0, 0, 0, 1, 1}};
  Check(cone, *R3::MakeShape("cone", cone.arguments),
        {{-0x1.8565b66a58be7p-1, 0x1.4526ad00a42dp+1, 0x1.be92661f0d7c4p+0},
         {0x1.7db775ec90c83p-2, -0x1.00000000d749dp+0, -0x1.b5c3720d287a7p-1}},
        32);
}

}  // namespace
