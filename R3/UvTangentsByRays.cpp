#include "R3/UvTangentsByRays.h"

#include "R3/Warp.h"

namespace R3 {
namespace {

constexpr double step_share = 0x1p-15;  // relative to the size of the shape

/// Returns the difference of two nearby texture coordinates, across the seam if that is shorter.
double OverSeam(double difference) { return difference - std::round(difference); }

}  // namespace

UvTangents UvTangentsByRays(const Shape& shape, const Ray& ray, const Hit& hit, int element) {
  const Intersection at = shape.At(ray, hit, element);
  const Vector n = AsVector(at.normal);
  // Unbounded shapes repeat their texture every unit.
  const double step = step_share * (shape.IsBounded() ? shape.Bounds(element).Radius() : 1);
  const auto uv_at = [&](const Vector& aside) -> std::optional<R2::Point> {
    const Ray down{at.position + aside + step * n, -n, 0, 2 * step, ray.time};
    const auto found = shape.Intersect(down, element);
    if (!found || found->part != hit.part) return {};
    return shape.At(down, *found, element).uv;
  };
  const auto gain_over = [&](const Vector& aside) -> R2::Vector {
    const auto ahead = uv_at(aside), behind = uv_at(-aside);
    if (!ahead && !behind) return {};
    const R2::Vector gain = ahead.value_or(at.uv) - behind.value_or(at.uv);
    return (ahead && behind ? 0.5 : 1) * R2::Vector{OverSeam(gain.x), OverSeam(gain.y)};
  };
  const Tangents tangents = TangentsOf(n);
  const Vector first = step * tangents.first, second = step * tangents.second;
  return {first, second, gain_over(first), gain_over(second)};
}

}  // namespace R3
