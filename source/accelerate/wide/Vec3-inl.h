// Vectors of space in SIMD lanes. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_VEC3_INL_H_
#undef RAY_ACCELERATE_WIDE_VEC3_INL_H_
#else
#define RAY_ACCELERATE_WIDE_VEC3_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One vector per lane.
template <typename D>
struct Vec3 {
  hn::Vec<D> x, y, z;
};

/// Returns one vector broadcast to all lanes.
template <typename D, typename Xyz>
HWY_INLINE Vec3<D> Broadcast(D d, const Xyz& v) {
  return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}
/// Returns the vectors from number i on; each component is an array.
template <typename D, typename Arrays>
HWY_INLINE Vec3<D> LoadEach(D d, const Arrays& v, std::size_t i) {
  return {hn::Load(d, v[0] + i), hn::Load(d, v[1] + i), hn::Load(d, v[2] + i)};
}
template <typename D>
HWY_INLINE Vec3<D> operator-(const Vec3<D>& a, const Vec3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <typename D>
HWY_INLINE hn::Vec<D> Dot(const Vec3<D>& a, const Vec3<D>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
template <typename D>
HWY_INLINE Vec3<D> Cross(const Vec3<D>& a, const Vec3<D>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
/// Returns the sums of the magnitudes of the components.
template <typename D>
HWY_INLINE hn::Vec<D> SumOfAbs(const Vec3<D>& v) {
  return hn::Add(hn::Abs(v.x), hn::Add(hn::Abs(v.y), hn::Abs(v.z)));
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
