#include_next <hwy/highway.h>

// Highway up to 1.0.3, which Debian 12 has, knows no doubles in WebAssembly; these are what the kernels take.
#if HWY_MAJOR == 1 && HWY_MINOR == 0 && HWY_PATCH <= 3 && !defined(SOURCE_WEB_SHIM_HIGHWAY_DOUBLES)
#define SOURCE_WEB_SHIM_HIGHWAY_DOUBLES

HWY_BEFORE_NAMESPACE();
namespace hwy {
namespace HWY_NAMESPACE {

template <size_t N>
using Doubles = Vec128<double, N>;

template <size_t N, HWY_IF_LE128(double, N)>
HWY_API Doubles<N> Set(Simd<double, N, 0>, double x) {
  return Doubles<N>{wasm_f64x2_splat(x)};
}

#define WEB_BINARY(name, operation)                              \
  template <size_t N>                                            \
  HWY_API Doubles<N> name(const Doubles<N> a, const Doubles<N> b) { \
    return Doubles<N>{operation(a.raw, b.raw)};                  \
  }
WEB_BINARY(operator+, wasm_f64x2_add)
WEB_BINARY(operator-, wasm_f64x2_sub)
WEB_BINARY(operator*, wasm_f64x2_mul)
WEB_BINARY(operator/, wasm_f64x2_div)
WEB_BINARY(Min, wasm_f64x2_min)
WEB_BINARY(Max, wasm_f64x2_max)
#undef WEB_BINARY

#define WEB_COMPARISON(name, operation)                                    \
  template <size_t N>                                                      \
  HWY_API Mask128<double, N> name(const Doubles<N> a, const Doubles<N> b) { \
    return Mask128<double, N>{operation(a.raw, b.raw)};                    \
  }
WEB_COMPARISON(operator==, wasm_f64x2_eq)
WEB_COMPARISON(operator<, wasm_f64x2_lt)
WEB_COMPARISON(operator>, wasm_f64x2_gt)
WEB_COMPARISON(operator<=, wasm_f64x2_le)
WEB_COMPARISON(operator>=, wasm_f64x2_ge)
#undef WEB_COMPARISON

template <size_t N>
HWY_API Doubles<N> Abs(const Doubles<N> v) {
  return Doubles<N>{wasm_f64x2_abs(v.raw)};
}
template <size_t N>
HWY_API Doubles<N> MulAdd(const Doubles<N> a, const Doubles<N> b, const Doubles<N> c) {
  return a * b + c;
}
template <size_t N>
HWY_API Doubles<N> MulSub(const Doubles<N> a, const Doubles<N> b, const Doubles<N> c) {
  return a * b - c;
}
template <size_t N>
HWY_API Doubles<N> NegMulAdd(const Doubles<N> a, const Doubles<N> b, const Doubles<N> c) {
  return c - a * b;
}
template <size_t N>
HWY_API Vec128<float, N> DemoteTo(Simd<float, N, 0>, const Doubles<N> v) {
  return Vec128<float, N>{wasm_f32x4_demote_f64x2_zero(v.raw)};
}

}  // namespace HWY_NAMESPACE
}  // namespace hwy
HWY_AFTER_NAMESPACE();

#endif
