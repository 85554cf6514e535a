#include "source/integrate/Bump.h"

#include <cmath>

#include "R3/Warp.h"

namespace ray {
namespace {

// How far aside texture coordinates are asked for, of the size of what was hit: small beside its curves, large beside
// the rounding of its points.
constexpr double step_aside = 0x1p-12;

/// The slope of the texture's luminance along u and v, over the width of one texel.
R2::Point Slope(const Texture& texture, const R2::Point& uv) {
  const double u = 0.5 / texture.image.Width(), v = 0.5 / texture.image.Height();
  const auto height = [&](double du, double dv) { return Luminance(texture.At({uv.x + du, uv.y + dv})); };
  return {(height(u, 0) - height(-u, 0)) / (2 * u), (height(0, v) - height(0, -v)) / (2 * v)};
}

/// From one texture coordinate to another nearby, over the seam where that is shorter.
double Wrapped(double difference) { return difference - std::round(difference); }

}  // namespace

R3::Vector Bumped(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at,
                  const Material& material, const R3::Vector& N, bool entering) {
  const Instance& instance = world.Instances()[hit.instance];
  // What has no end repeats its texture at every unit.
  const double size =
      instance.is_bounded ? world.InWorld(instance.frame, instance.shape->Bounds(hit.element)).Radius() : 1;
  const double step = step_aside * size;
  if (!(step > 0)) return N;
  const R3::Vector n = AsVector(at.normal);

  const auto uv_at = [&](const R3::Vector& aside) -> std::optional<R2::Point> {
    const R3::Ray down{at.position + aside + step * n, -n, 0, 2 * step, ray.time};
    const R3::Ray local = world.Back(instance.frame, down);
    const auto found = instance.shape->Intersect(local, hit.element);
    if (!found) return {};
    return world.At(down, {*found, hit.instance, hit.element}).uv;
  };
  const R2::Point slope = Slope(*material.bump, at.uv);
  const auto rise_along = [&](const R3::Vector& tangent) {
    const auto ahead = uv_at(step * tangent), behind = uv_at(-step * tangent);
    if (!ahead && !behind) return 0.0;
    const R2::Point from = behind.value_or(at.uv), to = ahead.value_or(at.uv);
    const double way = ahead && behind ? 2 * step : step;
    return (slope.x * Wrapped(to.x - from.x) + slope.y * Wrapped(to.y - from.y)) / way;
  };
  const R3::Tangents tangents = R3::TangentsOf(n);
  const R3::Vector rise = rise_along(tangents.first) * tangents.first + rise_along(tangents.second) * tangents.second;
  const double side = entering ? 1 : -1;
  const R3::Vector bumped = N - side * material.bump_height * rise;
  return Length(bumped) > 0 ? Unit(bumped) : N;
}

}  // namespace ray
