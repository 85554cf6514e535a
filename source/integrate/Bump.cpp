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

/// How texture coordinates change over a surface around a point that was hit, found by asking the shape a little aside.
class UvDerivatives {
 public:
  UvDerivatives(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at)
      : world_(world), ray_(ray), hit_(hit), at_(at), n_(AsVector(at.normal)) {
    const Instance& instance = world.Instances()[hit.instance];
    // What has no end repeats its texture at every unit.
    const double size =
        instance.is_bounded ? world.InWorld(instance.frame, instance.shape->Bounds(hit.element)).Radius() : 1;
    step_ = step_aside * size;
  }

  /// False on what is a point.
  bool AreKnown() const { return step_ > 0; }
  /// du/dx and dv/dx along a unit vector of the tangent plane, not divided yet; 0 where nothing is to either side.
  struct Quotient {
    double du = 0, dv = 0, dx = 1;
  };
  Quotient Along(const R3::Vector& tangent) const {
    const auto ahead = UvAt(step_ * tangent), behind = UvAt(-step_ * tangent);
    if (!ahead && !behind) return {};
    const R2::Point from = behind.value_or(at_.uv), to = ahead.value_or(at_.uv);
    return {Wrapped(to.x - from.x), Wrapped(to.y - from.y), ahead && behind ? 2 * step_ : step_};
  }

 private:
  std::optional<R2::Point> UvAt(const R3::Vector& aside) const {
    const Instance& instance = world_.Instances()[hit_.instance];
    const R3::Ray down{at_.position + aside + step_ * n_, -n_, 0, 2 * step_, ray_.time};
    const R3::Ray local = world_.Back(instance.frame, down);
    const auto found = instance.shape->Intersect(local, hit_.element);
    if (!found) return {};
    return world_.At(down, {*found, hit_.instance, hit_.element}).uv;
  }

  const World& world_;
  const R3::Ray& ray_;
  const WorldHit& hit_;
  const R3::Intersection& at_;
  R3::Vector n_;
  double step_;
};

}  // namespace

R3::Vector Bumped(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at,
                  const Material& material, const R3::Vector& N, bool entering) {
  const UvDerivatives uv(world, ray, hit, at);
  if (!uv.AreKnown()) return N;
  const R2::Point slope = Slope(*material.bump, at.uv);
  const auto rise_along = [&](const R3::Vector& tangent) {
    const UvDerivatives::Quotient change = uv.Along(tangent);
    return (slope.x * change.du + slope.y * change.dv) / change.dx;
  };
  const R3::Tangents tangents = R3::TangentsOf(AsVector(at.normal));
  const R3::Vector rise = rise_along(tangents.first) * tangents.first + rise_along(tangents.second) * tangents.second;
  const double side = entering ? 1 : -1;
  const R3::Vector bumped = N - side * material.bump_height * rise;
  return Length(bumped) > 0 ? Unit(bumped) : N;
}

R3::Vector NormalMapped(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at,
                        const Material& material, const R3::Vector& N, bool entering) {
  const UvDerivatives uv(world, ray, hit, at);
  if (!uv.AreKnown()) return N;
  const R3::Tangents tangents = R3::TangentsOf(AsVector(at.normal));
  const UvDerivatives::Quotient a = uv.Along(tangents.first), b = uv.Along(tangents.second);
  // Along u grows what v does not change along, and the other way round; the sign says which of both ways.
  const double turn = (a.du * b.dv - a.dv * b.du) / (a.dx * b.dx);
  if (!(turn != 0)) return N;
  const double sign = turn > 0 ? 1 : -1;
  const R3::Vector along_u = sign * (b.dv / b.dx * tangents.first - a.dv / a.dx * tangents.second);
  const R3::Vector along_v = sign * (a.du / a.dx * tangents.second - b.du / b.dx * tangents.first);
  const R2::Color c = material.normal_map->At(at.uv);
  const double side = entering ? 1 : -1;
  const R3::Vector mapped = side * ((2 * c.r - 1) * Unit(along_u) + (2 * c.g - 1) * Unit(along_v)) + (2 * c.b - 1) * N;
  return Length(mapped) > 0 && c != R2::Color{} ? Unit(mapped) : N;
}

}  // namespace ray
