// Triangle tests in double precision, one for each ray of a packet. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_PACKET_EXACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_PACKET_EXACT_INL_H_
#undef RAY_ACCELERATE_WIDE_PACKET_EXACT_INL_H_
#else
#define RAY_ACCELERATE_WIDE_PACKET_EXACT_INL_H_
#endif

#include "R3/Triangle.h"
#include "source/accelerate/wide/Packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// The results of the tests of ExactTriangleLanes, as bits.
struct ExactMask {
  std::uint32_t hit = 0;
  std::uint32_t unsure = 0;  // areas leave the range of doubles or are 0: to be tested one at a time
};

/// R3::IntersectTriangleInline for several rays, each with a separate triangle: the same operations in the same order,
/// and therefore the same bits.
class ExactTriangleLanes {
 public:
  static constexpr bool is_compiled = HWY_NATIVE_FMA != 0;  // without fused operations, separate tests are as fast

  /// Adds a test, at most packet_size of them.
  HWY_INLINE void Add(const R3::Ray& ray, double t_max, const std::array<const R3::Point*, 3>& corners) {
    const R3::ShearAxes axes(ray.direction);
    const auto put = [&](DoubleEach(&each)[3], const R3::Vector& permuted) HWY_ATTR {
      each[0][count_] = permuted.x, each[1][count_] = permuted.y, each[2][count_] = permuted.z;
    };
    put(origin_, axes.Permuted(ray.origin));
    put(direction_, axes.Permuted(ray.direction));
    for (std::size_t c = 0; c < 3; ++c) put(corner_[c], axes.Permuted(*corners[c]));
    t_min_[count_] = ray.t_min, t_max_[count_] = t_max;
    ++count_;
  }

  /// Runs all added tests.
  HWY_INLINE ExactMask Test() {
    ExactMask mask;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); i += hn::Lanes(PacketDoubles())) TestLanes(i, mask);
    const std::uint32_t all = (std::uint32_t{1} << count_) - 1;
    mask.hit &= all, mask.unsure &= all;
    return mask;
  }

  /// Returns the hit of ray i, whose test must have hit.
  R3::Hit HitOf(int i) const { return {t_[i], u_[i], v_[i], 0}; }

 private:
  HWY_INLINE void TestLanes(std::size_t i, ExactMask& mask) {
    const PacketDoubles d;
    const auto load = [&](const DoubleEach& each) HWY_ATTR { return hn::Load(d, each + i); };
    const auto z_scale = hn::Div(hn::Set(d, 1), load(direction_[2]));
    const auto x_shear = hn::Mul(load(direction_[0]), z_scale), y_shear = hn::Mul(load(direction_[1]), z_scale);
    using V = hn::Vec<PacketDoubles>;
    V x[3], y[3], z[3];
    for (int c = 0; c < 3; ++c) {
      z[c] = hn::Sub(load(corner_[c][2]), load(origin_[2]));
      x[c] = hn::Sub(hn::Sub(load(corner_[c][0]), load(origin_[0])), hn::Mul(x_shear, z[c]));
      y[c] = hn::Sub(hn::Sub(load(corner_[c][1]), load(origin_[1])), hn::Mul(y_shear, z[c]));
    }
    const auto difference_of_products = [](V a, V b, V c, V e) HWY_ATTR {
      const V ce = hn::Mul(c, e);
      return hn::Add(hn::MulSub(a, b, ce), hn::NegMulAdd(c, e, ce));
    };
    const V edge_u = difference_of_products(x[2], y[1], y[2], x[1]);
    const V edge_v = difference_of_products(x[0], y[2], y[0], x[2]);
    const V edge_w = difference_of_products(x[1], y[0], y[1], x[0]);
    const V zero = hn::Zero(d);
    const auto some_below = hn::Or(hn::Lt(edge_u, zero), hn::Or(hn::Lt(edge_v, zero), hn::Lt(edge_w, zero)));
    const auto some_above = hn::Or(hn::Gt(edge_u, zero), hn::Or(hn::Gt(edge_v, zero), hn::Gt(edge_w, zero)));
    const auto have_both_signs = hn::And(some_below, some_above);
    const V sum = hn::Add(hn::Add(edge_u, edge_v), edge_w), size = hn::Abs(sum);
    const auto is_in_range =
        hn::And(hn::Ge(size, hn::Set(d, R3::least_square)), hn::Le(size, hn::Set(d, R3::most_square)));
    const V heights = hn::Add(hn::Add(hn::Mul(edge_u, z[0]), hn::Mul(edge_v, z[1])), hn::Mul(edge_w, z[2]));
    const V t = hn::Mul(hn::Div(heights, sum), z_scale);
    const auto is_between = hn::And(hn::Gt(t, load(t_min_)), hn::Lt(t, load(t_max_)));
    hn::Store(t, d, t_ + i);
    hn::Store(hn::Div(edge_v, sum), d, u_ + i);
    hn::Store(hn::Div(edge_w, sum), d, v_ + i);
    mask.hit |= Bits(d, hn::AndNot(have_both_signs, hn::And(is_in_range, is_between))) << i;
    mask.unsure |= Bits(d, hn::Not(hn::Or(have_both_signs, is_in_range))) << i;
  }

  int count_ = 0;
  // Axes are permuted separately for each ray.
  alignas(64) DoubleEach origin_[3], direction_[3], corner_[3][3], t_min_, t_max_;
  alignas(64) DoubleEach t_, u_, v_;  // of hits
};

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
