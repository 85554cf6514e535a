// Difficult surfaces, compared with a search in 113 bits that shares no code, to verify that no root is missed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "R3/Implicit.h"
#include "R3/ShapeKind.h"
#include "tests/Crossings.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

#if defined(__SIZEOF_FLOAT128__)
extern "C" {
Quad sinq(Quad), expq(Quad);
}
#else
Quad sinq(Quad x) { return std::sin(x); }
Quad expq(Quad x) { return std::exp(x); }
#endif

namespace {

Quad Sin(Quad x) { return sinq(x); }
Quad Exp(Quad x) { return expq(x); }
double Sin(double x) { return std::sin(x); }
double Exp(double x) { return std::exp(x); }
Quad Abs(Quad x) { return x < 0 ? -x : x; }
double Abs(double x) { return std::abs(x); }
template <typename N>
N Max(N a, N b) {
  return a > b ? a : b;
}

/// A formula as text, and as a function in doubles and in 113 bits.
struct Nasty {
  const char *name, *formula;
  double (*rough)(double, double, double);
  Quad (*exact)(Quad, Quad, Quad);
};

#define NASTY(name, formula, ...)                               \
  Nasty {                                                       \
    name, formula, [](double x, double y, double z) -> double { \
      using N [[maybe_unused]] = double;                        \
      (void)x, (void)y, (void)z;                                \
      return __VA_ARGS__;                                       \
    },                                                          \
        [](Quad x, Quad y, Quad z) -> Quad {                    \
          using N [[maybe_unused]] = Quad;                      \
          (void)x, (void)y, (void)z;                            \
          return __VA_ARGS__;                                   \
        }                                                       \
  }

const Nasty surfaces[] = {
    NASTY("plates of 2e-9", "abs(sin(10 pi x)) - 3e-8", Abs(Sin(N(10) * N(std::numbers::pi) * x)) - N(3e-8)),
    NASTY("a shell of 1e-5", "(x^2 + y^2 + z^2 - 1)^2 - 1e-10",
          (x * x + y * y + z * z - 1) * (x * x + y * y + z * z - 1) - N(1e-10)),
    NASTY("a double root", "(x^2 + y^2 + z^2 - 1)^2",
          (x * x + y * y + z * z - 1) * (x * x + y * y + z * z - 1)),
    NASTY("an apex without a gradient", "x^2 + y^2 - z^2", x * x + y * y - z * z),
    NASTY("crossing sheets", "x^2 y^2 + y^2 z^2 + z^2 x^2 - 2 x y z",
          x * x * y * y + y * y * z * z + z * z * x * x - 2 * x * y * z),
    NASTY("a heart", "(x^2 + 2.25 y^2 + z^2 - 1)^3 - x^2 z^3 - 0.1125 y^2 z^3",
          (x * x + N(2.25) * y * y + z * z - 1) * (x * x + N(2.25) * y * y + z * z - 1) *
                  (x * x + N(2.25) * y * y + z * z - 1) -
              x * x * z * z * z - N(0.1125) * y * y * z * z * z),
    NASTY("a cusp", "y^2 - x^3", y * y - x * x * x),
    NASTY("a slab of 2e-9", "max(max(abs(x) - 1, abs(y) - 1), abs(z) - 1e-9)",
          Max(Max(Abs(x) - 1, Abs(y) - 1), Abs(z) - N(1e-9))),
    NASTY("many cells", "sin(20 x) + sin(20 y) + sin(20 z)", Sin(20 * x) + Sin(20 * y) + Sin(20 * z)),
    NASTY("a spike", "exp(-1000 (x^2 + y^2)) - 0.5 - 0.1 z", Exp(N(-1000) * (x * x + y * y)) - N(0.5) - N(0.1) * z),
};

/// The formula along a ray.
struct Line {
  const Nasty& surface;
  R3::Ray ray;

  double Rough(double t) const {
    const R3::Point p = ray.At(t);
    return surface.rough(p.x, p.y, p.z);
  }
  Quad Exact(Quad t) const {
    return surface.exact(ray.origin.x + t * Quad(ray.direction.x), ray.origin.y + t * Quad(ray.direction.y),
                         ray.origin.z + t * Quad(ray.direction.z));
  }
};

/// The distance to 0 below which doubles cannot decide on which side a point is.
constexpr double rounding = 1e-12;

/// Returns the point between two others at which the magnitude of the formula is smallest, by golden section.
Quad LeastBetween(const Line& line, Quad low, Quad high) {
  const Quad golden = (oracle::Sqrt(5) - 1) / 2;
  Quad a = high - golden * (high - low), b = low + golden * (high - low);
  Quad at_a = Abs(line.Exact(a)), at_b = Abs(line.Exact(b));
  for (int i = 0; i < 80; ++i)
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a, a = high - golden * (high - low), at_a = Abs(line.Exact(a));
    } else {
      low = a, a = b, at_a = at_b, b = low + golden * (high - low), at_b = Abs(line.Exact(b));
    }
  return at_a < at_b ? a : b;
}

/// Returns true if the point is inside; std::nullopt if rounding decides.
std::optional<bool> IsInside(const Line& line, Quad t) {
  const Quad value = line.Exact(t);
  if (Abs(value) < rounding) return {};
  return value < 0;
}

/// Returns the number of points of the stretch on another side than the crossings found imply.
///   samples   evenly along it, and one more wherever the magnitude is smallest between two of them
int Misjudged(const Line& line, double enter, double leave, const std::vector<double>& found, int samples) {
  int misjudged = 0;
  const auto judge = [&](Quad t) {
    const auto inside = IsInside(line, t);
    const auto before = std::ranges::count_if(found, [&](double x) { return Quad(x) <= t; });
    misjudged += inside && *inside != (before % 2 == 1);
  };
  const double step = (leave - enter) / samples;
  double behind = 0, middle = std::abs(line.Rough(enter + step / 4));
  for (int i = 0; i < samples; ++i) {
    const double t = enter + (i + 0.25) * step, value = line.Rough(t);
    const bool inside = value < 0;
    const auto before = std::ranges::count_if(found, [&](double x) { return x <= t; });
    if (inside != (before % 2 == 1)) judge(t);
    const double ahead = std::abs(line.Rough(t + step));
    // The magnitude is smallest here between its neighbors, so it may be 0 close to it.
    if (i > 0 && middle <= behind && middle <= ahead) judge(LeastBetween(line, t - step, t + step));
    behind = middle, middle = ahead;
  }
  return misjudged;
}

/// Half of the rays pass near the middle of the surfaces, where gradients vanish.
R3::Ray RayNearMiddle(Draw& draw) {
  const R3::Vector d = draw.Direction();
  const R3::Vector aside = draw.Whole(0, 1) ? draw.Scale(-6, 0) * draw.Direction() : 1.5 * draw.Direction();
  return {R3::Point{} + aside - 5 * d, d};
}

TEST(Implicit, MissesNoRootOfTenNastySurfaces) {
  const int rays = Asked("IMPLICIT_RAYS", 1000, 1'000'000);
  const R3::Box box{{-2, -2, -2}, {2, 2, 2}};
  for (const Nasty& surface : surfaces) {
    const R3::Implicit solid{R3::Expression(surface.formula), box};
    Draw draw(71);
    int misjudged = 0, met = 0;
    for (int i = 0; i < rays / 10; ++i) {
      const R3::Ray ray = RayNearMiddle(draw);
      const auto around = crossings::Along(*R3::MakeShape("box", {-2, -2, -2, 2, 2, 2}), ray);
      if (around.size() != 2) continue;
      const std::vector<double> found = crossings::Along(solid, ray);
      const int wrong = Misjudged({surface, ray}, around[0], around[1], found, 256);
      EXPECT_EQ(wrong, 0) << surface.name << ' ' << oracle::Hex(ray);
      misjudged += wrong, met += !found.empty();
    }
    EXPECT_EQ(misjudged, 0) << surface.name;
    EXPECT_TRUE(met > 0 || surface.name == std::string("a double root")) << surface.name;
  }
}

}  // namespace
