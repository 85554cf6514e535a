#include "source/integrate/shading/Bump.h"

namespace ray {
namespace {

/// Returns the slope of the texture's luminance along u and v. The lookup is smoothed over one texel along either,
/// since the slope of a plain bilinear lookup, and the shading with it, jumps at the center of every texel.
R2::Vector Slope(const Texture& texture, const R3::SurfacePoint& surface, const R2::Vector& scale) {
  const TexturePlace at = PlaceOnTexture(surface, scale);
  const double u = 0.5 / texture.image.Width(), v = 0.5 / texture.image.Height();
  const auto height = [&](double du, double dv) {
    return Luminance(texture.At({at.uv.x + du, at.uv.y + dv}, at.v_ends));
  };
  return {scale.x * ((height(u, 0) - height(-u, 0)) / (2 * u)), scale.y * ((height(0, v) - height(0, -v)) / (2 * v))};
}

/// Returns the direction of `v`; `other` if v is 0 or not finite.
R3::Vector UnitOr(const R3::Vector& other, const R3::Vector& v) {
  const R3::Vector unit = Unit(v);
  return unit == R3::Vector{} ? other : unit;
}

/// Returns the sign that converts a tilt outward to one on the viewer's side.
double SideOf(const ShadingPoint& p) { return p.entering ? 1 : -1; }

}  // namespace

R3::Vector Bumped(const ShadingPoint& p, const R3::UvTangents& uv) {
  const R3::Vector n = AsVector(p.at.normal), first = Unit(uv.first), second = Unit(uv.second);
  const double area = Dot(n, Cross(first, second));  // 0, so that the result is not finite, if they are parallel
  const R2::Vector slope = Slope(*p.material->bump, p.at, p.material->texture_scale);
  const double along_first = Dot(slope, uv.gain_first) / Length(uv.first),
               along_second = Dot(slope, uv.gain_second) / Length(uv.second);
  const R3::Vector gradient = (along_first * Cross(second, n) + along_second * Cross(n, first)) / area;
  return UnitOr(p.N, p.N - SideOf(p) * p.material->bump_height * gradient);
}

R3::Vector NormalMapped(const ShadingPoint& p, const R3::UvTangents& uv) {
  const auto [du_first, dv_first] = uv.gain_first;
  const auto [du_second, dv_second] = uv.gain_second;
  // u grows along the direction in which v is constant, and vice versa; the sign selects the sense.
  const double turn = R3::DifferenceOfProducts(du_first, dv_second, dv_first, du_second);
  const double sign = turn > 0 ? 1 : -1;
  const R3::Vector along_u = Unit(sign * (dv_second * uv.first - dv_first * uv.second)),
                   along_v = Unit(sign * (du_first * uv.second - du_second * uv.first));
  const R2::Color c = p.material->normal_map->On(p.at, p.material->texture_scale);
  if (turn == 0 || c == R2::Color{}) return p.N;
  return UnitOr(p.N, SideOf(p) * ((2 * c.r - 1) * along_u + (2 * c.g - 1) * along_v) + (2 * c.b - 1) * p.N);
}

}  // namespace ray
