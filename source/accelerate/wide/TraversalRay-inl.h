// A ray for traversal in single precision, and its error bounds. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_TRAVERSAL_RAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_TRAVERSAL_RAY_INL_H_
#undef RAY_ACCELERATE_WIDE_TRAVERSAL_RAY_INL_H_
#else
#define RAY_ACCELERATE_WIDE_TRAVERSAL_RAY_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "R3/Departure.h"
#include "source/accelerate/twolevel/TwoLevel.h"
#include "source/accelerate/wide/Vec3-inl.h"

// Traversal is watertight and conservative: wherever single precision may be wrong, the test is repeated in double
// precision. All coordinates are the structure's, so at most 1 in boxes and triangles; directions are scaled so that
// their largest component lies in [1, 2); u is 2^-24. With r = 1 + the largest coordinate of the ray's origin:
//   - A plane rounded to float is off by u/2, the origin by u r, their product with 1/d by u r, 1/d itself (with d
//     rounded before) by 2 u of the distance, at most 2 u r, the difference by u r: together less than 8 u r in terms
//     of the plane's position. So each ray moves all planes outward by 8 u r: its plane error bound.
//   - With |e| the sum of magnitudes of an edge's components: corner - origin is off by 2 u r and at most r in each, so
//     R = (corner - origin) x d, at most 4 r, is off by 20 u r in each, R . e by (20 + 12 + 4) u r |e|. The normal n is
//     off by 5 u |e1| |e2| in each component, n . d by 32 u |e1| |e2|, n . (corner - origin) by 16 u r |e1| |e2|.
//   - Doubles lose 2^-50 of the origin's distance before it was moved near; r includes 2^-20 u of that distance.
// So a triangle whose edge functions (its barycentric coordinates, undivided) all exceed their error bound is certainly
// hit, by the exact test too; its distance is then known between two bounds, of which the upper one already ends the
// search. The exact test in doubles decides about the few candidates that remain in the end. Where Contact.h decides,
// at the start of a ray and at the end of a shadow ray, nothing is certain. Hits that may be coincident with the
// nearest hit are off by less than 2^9 double roundings of the ray's origin, far less than u r; adding 1 u r to the
// bound includes them.
HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

using Lanes = hn::CappedTag<float, width>;
using Floats = hn::Vec<Lanes>;

inline constexpr float u = 0x1p-24f;

// The bounds above: of planes, times r; of edge functions, times r (|e1| + |e2|), 36 u and a margin for sums of the
// bounds themselves; of n . (corner - origin), times (r + 1) |e1| |e2|; of n . d, times |e1| |e2|.
inline constexpr float relative_plane_error = 8 * u, relative_edge_error = 40 * u, relative_height_error = 17 * u,
                       relative_facing_error = 32 * u;
/// An addition to the error bounds of triangles, for products below the normal range of floats, 2^-126. An edge
/// function has some 30 terms, each off by at most 2^-126 if such products became 0, times at most 4 for later factors:
/// together less than 2^-119. A height has the corner as a factor, which may be large; but heights count only if n . d
/// is above twice this value, and then |e1| |e2| is above 2^-101, so that the loss, 2^-149 r at most for each component
/// of n, is far less than the height's own bound.
inline constexpr float underflow_error = 0x1p-99f;
/// The share of the distance that a ray came from that is added to r, for the loss of doubles on the way.
inline constexpr double translation_error = 0x1p-20;
/// Factors that turn computed distances into bounds, after a rounded division or conversion and including the product's
/// own rounding.
inline constexpr float rounded_up = 1 + 4 * u, rounded_down = 1 - 4 * u;

/// The distance of an origin, in half boxes, up to which rays begin where they are. It makes r, and therefore the error
/// bounds, at most 7 times as large as inside, and saves computing the entry.
inline constexpr double near_enough = 6;
/// The minimum magnitude of a direction's components. It moves rays by less than their error bound, and keeps products
/// finite.
inline constexpr float flattest = 0x1p-40f;
/// The reach beyond which single precision is useless, long since; r / flattest is still finite there.
inline constexpr double most_reach = 0x1p60;

/// Returns 2^-e for x in [2^e, 2^(e+1)), which must be finite and not 0; at least 2^-1022 and at most 2^1022.
HWY_INLINE double PowerOfTwoBelowInverse(double x) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff;
  return std::bit_cast<double>(std::clamp<std::uint64_t>(2046 - exponent, 1, 2045) << 52);
}
/// Returns 1 / x for a power of two returned by the function above.
HWY_INLINE double InverseOfPowerOfTwo(double x) {
  return std::bit_cast<double>((std::uint64_t{2046} << 52) - std::bit_cast<std::uint64_t>(x));
}

// Four numbers in a vector type of the compilers; the fourth is whatever follows the third in memory.
using Double4 = double __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Whole4 = std::int32_t __attribute__((vector_size(16)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

HWY_INLINE void Load(const double* xyz, Double4& v) { std::memcpy(&v, xyz, sizeof v); }
HWY_INLINE double LargestOf(const Double4& v) {
  const auto larger = [](double a, double b) {
    return a > b ? a : b;
  };  // values, so that it is an instruction, not a branch
  Long4 bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= std::numeric_limits<std::int64_t>::max();
  Double4 size;
  std::memcpy(&size, &bits, sizeof size);
  return larger(larger(size[0], size[1]), size[2]);
}

/// A ray in a structure's coordinates. If it comes from afar, it begins where it enters the structure's box.
struct TraversalRay {
  Double4 start, along;  // its origin and its direction
  Float4 origin, direction, inverse;
  Float4 near_shift, far_shift;  // (origin +- plane_error) * inverse
  Whole4 signs;                  // below 0 if the direction is
  float plane_error;
  float certain_from;    // no hit nearer than this is certain
  float edge_error;      // to be multiplied by |e1| + |e2|
  float height_error;    // to be multiplied by |e1| |e2|
  double per_t, begin;   // distance along this ray = t * per_t - begin
  bool is_lost = false;  // it misses the structure's box

  /// Returns -1 if the ray descends along the axis, otherwise 0.
  std::int32_t DownwardMask(int axis) const { return signs[axis] >> 31; }
  /// Returns an upper bound on the distance.
  float Distance(double t) const { return static_cast<float>(t * per_t - begin) * rounded_up + plane_error; }

  HWY_INLINE TraversalRay(const Coordinates& coordinates, double padding_per_distance, const R3::Ray& ray,
                          double distance_in_world) {
    static_assert(sizeof(R3::Ray) >= 8 * sizeof(double) && sizeof(R3::Point) == 3 * sizeof(double));
    static_assert(sizeof(Coordinates) >= 4 * sizeof(double));
    Double4 center, eye, heading;
    Load(&coordinates.center.x, center), Load(&ray.origin.x, eye), Load(&ray.direction.x, heading);
    const Double4 from = coordinates.scale * (eye - center);
    const double power = PowerOfTwoBelowInverse(LargestOf(heading));
    along = power * heading;
    per_t = coordinates.scale * InverseOfPowerOfTwo(power);

    const double far = LargestOf(from);
    const double padding = padding_per_distance * distance_in_world * coordinates.scale;
    begin = ray.t_min == 0 || IsDeparting(ray) ? 0 : ray.t_min * per_t;
    if (HWY_UNLIKELY(far > near_enough + padding) && !EnterBox(from, far, padding, ray.t_max * per_t)) {
      is_lost = true;
      return;
    }
    double far_from_start = far;
    start = from;
    if (begin != 0) start = from + begin * along, far_from_start = LargestOf(start);
    const double reach =
        1 + far_from_start + translation_error * (far + std::abs(begin)) + padding * (1 / relative_plane_error);
    SetErrorBounds(static_cast<float>(reach));
    certain_from = plane_error;
    if (IsDeparting(ray)) certain_from += static_cast<float>(-R3::departure_end * per_t * ray.t_min);
    Round();
    // If `begin` is out of range, so is the reach.
    const bool is_in_range = (per_t < coordinates.largest_per_t) & (per_t > 1 / most_per_t) & (reach < most_reach);
    if (HWY_UNLIKELY(!is_in_range)) AcceptEverything();
  }

 private:
  /// Moves the start to where the ray enters the structure's box, generously padded, so that coordinates are no larger
  /// than necessary; returns false if it misses the box.
  HWY_INLINE bool EnterBox(const Double4& from, double far, double padding, double leave) {
    const double reach = 1 + 0x1p-10 + 0x1p-40 * far + padding;
    double enter = begin;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (-reach - from[axis]) / along[axis], b = (reach - from[axis]) / along[axis];
      enter = std::max(enter, std::min(a, b));  // a NaN, from a ray in the plane, changes nothing
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave * (1 + 0x1p-40) + 0x1p-40 * far) return false;
    begin = enter;
    return true;
  }

  HWY_INLINE void SetErrorBounds(float r) {
    plane_error = relative_plane_error * r;
    edge_error = relative_edge_error * r;
    height_error = relative_height_error * (r + 1);
  }

  /// Rounds to single precision, and computes the values for box tests.
  HWY_INLINE void Round() {
    origin = __builtin_convertvector(start, Float4);
    direction = __builtin_convertvector(along, Float4);
    signs = std::bit_cast<Whole4>(direction);
    const Whole4 sign = signs & std::bit_cast<std::int32_t>(-0.0f);
    const Float4 steepness = std::bit_cast<Float4>(signs ^ sign), flat = Float4{} + flattest;
    const Float4 steep = std::bit_cast<Float4>(std::bit_cast<Whole4>(steepness > flat ? steepness : flat) | sign);
    inverse = 1 / steep;
    const Float4 outward = std::bit_cast<Float4>(std::bit_cast<Whole4>(Float4{} + plane_error) | sign);
    near_shift = (origin + outward) * inverse;
    far_shift = (origin - outward) * inverse;
  }

  /// Accepts everything, for rays that single precision cannot resolve.
  void AcceptEverything() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    plane_error = certain_from = edge_error = height_error = infinity;
    per_t = 1, begin = 0;
    origin = inverse = Float4{};
    near_shift = Float4{} + infinity, far_shift = -near_shift;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
