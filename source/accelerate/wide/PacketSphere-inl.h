// One sphere against the rays of a packet. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_PACKET_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_PACKET_SPHERE_INL_H_
#undef RAY_ACCELERATE_WIDE_PACKET_SPHERE_INL_H_
#else
#define RAY_ACCELERATE_WIDE_PACKET_SPHERE_INL_H_
#endif

#include "source/accelerate/wide/Packet-inl.h"

// With f from the center to the origin, a line of direction d meets the sphere where |f x d| <= radius |d|. In single
// precision, with u and r as in TraversalRay-inl.h:
//   - Components of f are at most r and off by 2 u r, those of d at most 2 and off by 2 u, so a component of f x d is
//     off by (2 * 6 + 8) u r = 20 u r, the vector by less than e = 6 plane errors = 48 u r; and f . d by 30 u r.
//   - |d| < 3.5, so a line that certainly misses has |f x d|^2 > radius^2 d^2 + 7 e radius + e^2, one that certainly
//   meets
//     it |f x d|^2 + 7 e radius + e^2 < radius^2 d^2. Squares and products round by less than 16 u together.
// A ray whose line meets the sphere leaves it at t = (-f . d + a number from 0 to radius |d|) / d^2. If that certainly
// lies between 0 and its limit, the ray hits, whether it begins inside or outside.
HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// A sphere in a structure's coordinates, in single precision.
struct RoundedSphere {
  float center[3], radius;

  HWY_INLINE RoundedSphere(const Coordinates& coordinates, const R3::SphereData& sphere)
      : center{Rounded(coordinates, sphere, 0), Rounded(coordinates, sphere, 1), Rounded(coordinates, sphere, 2)},
        radius(static_cast<float>(coordinates.scale * std::max(sphere.radius, 0.0))) {}

 private:
  static HWY_INLINE float Rounded(const Coordinates& coordinates, const R3::SphereData& sphere, int axis) {
    return static_cast<float>(coordinates.scale * (sphere.center[axis] - coordinates.center[axis]));
  }
};

/// The rays that may hit a sphere, and those that certainly do, as bits.
struct SphereMask {
  std::uint32_t maybe = 0, certain = 0;
};

/// Tests the rays. With `any`, also finds the certain hits: those before `limit`, which has one distance per ray.
template <bool any>
HWY_INLINE SphereMask TestSphereLanes(const RoundedSphere& sphere, const Packet& packet, const FloatEach& limit) {
  const PacketFloats f;
  using V = hn::Vec<PacketFloats>;
  const auto set = [&](float x) { return hn::Set(f, x); };
  constexpr float rounding = 16 * u;
  SphereMask mask;
  for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
    const Vec3<PacketFloats> from_center = LoadEach(f, packet.origin, i) - Broadcast(f, sphere.center);
    const Vec3<PacketFloats> direction = LoadEach(f, packet.direction, i), moment = Cross(from_center, direction);
    const V distance = Dot(moment, moment), square = Dot(direction, direction);
    const V error = hn::Mul(hn::Load(f, packet.plane_error + i), set(6));
    const V slack = hn::Mul(error, hn::Add(error, set(7 * sphere.radius)));
    const V reach = hn::Mul(set(sphere.radius * sphere.radius), square);
    mask.maybe |= Bits(f, hn::Not(hn::Gt(distance, hn::Mul(hn::Add(reach, slack), set(1 + rounding))))) << i;
    if constexpr (any) {
      const V ahead = hn::Neg(Dot(from_center, direction));
      const V farthest = hn::MulAdd(set(sphere.radius), hn::Sqrt(square), hn::Add(ahead, error));
      const auto is_met = hn::Lt(hn::Mul(hn::Add(distance, slack), set(1 + rounding)), reach);
      const auto is_before = hn::Lt(hn::Mul(farthest, set(1 + rounding)), hn::Mul(hn::Load(f, limit + i), square));
      const V least_ahead = hn::MulAdd(hn::Load(f, packet.certain_from + i), square, error);
      mask.certain |= Bits(f, hn::And(is_met, hn::And(hn::Gt(ahead, least_ahead), is_before))) << i;
    }
  }
  return mask;
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
