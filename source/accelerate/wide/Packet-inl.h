// Packets of coherent rays through a wide tree. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_PACKET_INL_H_
#undef RAY_ACCELERATE_WIDE_PACKET_INL_H_
#else
#define RAY_ACCELERATE_WIDE_PACKET_INL_H_
#endif

#include <span>

#include "source/accelerate/wide/Traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

inline constexpr int packet_size = 16;

using PacketFloats = hn::CappedTag<float, packet_size>;
using PacketDoubles = hn::CappedTag<double, packet_size>;
using PacketIds = hn::CappedTag<std::int64_t, packet_size>;

/// One number per ray.
using FloatEach = float[packet_size];
using DoubleEach = double[packet_size];
using IdEach = std::int64_t[packet_size];

/// The traversal rays of a packet in lanes, and their common bounds.
struct Packet {
  alignas(64) FloatEach origin[3], direction[3], inverse[3], near_shift[3], far_shift[3];
  alignas(64) FloatEach plane_error, certain_from, edge_error, height_error;
  alignas(64) FloatEach limit;  // below 0 for a ray that is finished
  alignas(64) DoubleEach per_t;
  // The primitives, in the world's numbering, on which rays start and end and which they do not meet; -1 for none.
  alignas(64) IdEach start_on, end_on;
  // Bounds over all rays, rounded outward: of their origins, the side farther from the near planes first, and of their
  // inverse directions; and the start of the near planes in Node::planes.
  float back[3], front[3], least_inverse[3], most_inverse[3];
  std::uint32_t planes[3];

  float Distance(int i, double t) const { return static_cast<float>(t * per_t[i]) * rounded_up + plane_error[i]; }

  /// Performs TraversalRay's computations for all rays at once. Returns false if one of them is unusual: then they must
  /// be prepared one at a time.
  HWY_INLINE bool Begin(const Coordinates& coordinates, double padding_per_distance, std::span<const R3::Ray> rays) {
    SceneRays from;
    Load(rays, from);
    if (!(coordinates.scale <= most_scale && coordinates.scale >= 1 / most_scale)) return false;
    bool is_ordinary = true;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(PacketDoubles()))
      is_ordinary &= BeginLanes(coordinates, padding_per_distance, from, i);
    if (!is_ordinary) return false;
    for (std::size_t i = rays.size(); i < packet_size; ++i) limit[i] = -1;
    for (int axis = 0; axis < 3; ++axis) Invert(axis);
    return true;
  }

  /// Computes the bounds over all rays. Returns false if one of them points to another octant: then they are traced one
  /// at a time.
  HWY_INLINE bool Enclose() {
    const PacketFloats f;
    for (int axis = 0; axis < 3; ++axis) {
      auto least = hn::Set(f, std::numeric_limits<float>::infinity()), most = hn::Neg(least);
      for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
        const auto slope = hn::Load(f, inverse[axis] + i);
        least = hn::Min(least, slope), most = hn::Max(most, slope);
      }
      least_inverse[axis] = hn::GetLane(hn::MinOfLanes(f, least));
      most_inverse[axis] = hn::GetLane(hn::MaxOfLanes(f, most));
      if (least_inverse[axis] < 0 && most_inverse[axis] > 0) return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
      auto low = hn::Set(f, std::numeric_limits<float>::infinity()), high = hn::Neg(low);
      for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
        const auto begin = hn::Load(f, origin[axis] + i), padding = hn::Load(f, plane_error + i);
        low = hn::Min(low, hn::Sub(begin, padding)), high = hn::Max(high, hn::Add(begin, padding));
      }
      back[axis] = hn::GetLane(hn::MinOfLanes(f, low)), front[axis] = hn::GetLane(hn::MaxOfLanes(f, high));
      const bool is_downward = most_inverse[axis] < 0;
      planes[axis] = 2 * width * static_cast<std::uint32_t>(axis) + (is_downward ? width : 0);
      if (is_downward) std::swap(back[axis], front[axis]);
    }
    return true;
  }

  /// Returns the rays, as bits, that start or end on a primitive and do not meet it.
  HWY_INLINE std::uint32_t StartOrEndOn(std::int64_t primitive) const {
    const PacketIds d;
    const auto it = hn::Set(d, primitive);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(d))
      bits |= Bits(d, hn::Or(hn::Eq(hn::Load(d, start_on + i), it), hn::Eq(hn::Load(d, end_on + i), it))) << i;
    return bits;
  }

  float LargestLimit() const {
    const PacketFloats f;
    auto most = hn::Load(f, limit);
    for (std::size_t i = hn::Lanes(f); i < packet_size; i += hn::Lanes(f)) most = hn::Max(most, hn::Load(f, limit + i));
    return hn::GetLane(hn::MaxOfLanes(f, most));
  }

  /// Returns the children of a node, as bits, that some ray may enter before `before`, with lower bounds on the
  /// entries. Uses interval bounds of (plane - origin) / direction for all origins and directions of the packet. Their
  /// rounding, 1/2 u for the plane, u r for origin and difference and 3 u r for the product, is within each ray's error
  /// bound.
  HWY_INLINE std::uint32_t Test(const Node& node, float before, float* HWY_RESTRICT entries) const {
    const Lanes lanes;
    std::uint32_t reached = 0;
    for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
      Floats entry = hn::Zero(lanes), exit = hn::Set(lanes, before);
      for (int axis = 0; axis < 3; ++axis) {
        const float* near = node.planes + planes[axis] + i;
        const float* far = node.planes + (planes[axis] ^ width) + i;
        const Floats least = hn::Set(lanes, least_inverse[axis]), most = hn::Set(lanes, most_inverse[axis]);
        const Floats to_near = hn::Sub(hn::Load(lanes, near), hn::Set(lanes, front[axis]));
        const Floats to_far = hn::Sub(hn::Load(lanes, far), hn::Set(lanes, back[axis]));
        entry = hn::Max(entry, hn::Min(hn::Mul(to_near, least), hn::Mul(to_near, most)));
        exit = hn::Min(exit, hn::Max(hn::Mul(to_far, least), hn::Mul(to_far, most)));
      }
      hn::Store(entry, lanes, entries + i);
      reached |= Bits(lanes, hn::Le(entry, exit)) << i;
    }
    return reached;
  }

  /// Returns the rays, as bits, that enter a child of a node before their limits. All rays of a coherent packet have
  /// the same near planes.
  template <bool coherent>
  HWY_INLINE std::uint32_t RaysThrough(const Node& node, int child) const {
    const PacketFloats f;
    const float* const all = node.planes + child;
    std::uint32_t through = 0;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
      auto entry = hn::Zero(f), exit = hn::Load(f, limit + i);
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t first = coherent ? planes[axis] : 2 * width * static_cast<std::uint32_t>(axis);
        auto near = hn::Set(f, all[first]), far = hn::Set(f, all[first ^ width]);
        const auto slope = hn::Load(f, inverse[axis] + i);
        if constexpr (!coherent) {
          const auto low = near, high = far;
          near = hn::IfNegativeThenElse(slope, high, low), far = hn::IfNegativeThenElse(slope, low, high);
        }
        entry = hn::Max(entry, hn::MulSub(near, slope, hn::Load(f, near_shift[axis] + i)));
        exit = hn::Min(exit, hn::MulSub(far, slope, hn::Load(f, far_shift[axis] + i)));
      }
      through |= Bits(f, hn::Le(entry, exit)) << i;
    }
    return through;
  }

 private:
  struct SceneRays {
    alignas(64) DoubleEach origin[3], direction[3], t_min, t_max;
    bool all_depart = true;

    /// Returns the lower bound of t_min; none is above 0, since all rays begin at once.
    double LeastTMin() const { return all_depart ? -std::numeric_limits<double>::infinity() : 0; }
  };

  /// Loads the rays; lanes without a ray repeat the last one.
  HWY_INLINE void Load(std::span<const R3::Ray> rays, SceneRays& from) {
    for (std::size_t i = 0; i < packet_size; ++i) {
      const R3::Ray& ray = rays[std::min(i, rays.size() - 1)];
      from.origin[0][i] = ray.origin.x, from.origin[1][i] = ray.origin.y, from.origin[2][i] = ray.origin.z;
      from.direction[0][i] = ray.direction.x, from.direction[1][i] = ray.direction.y;
      from.direction[2][i] = ray.direction.z;
      from.t_min[i] = ray.t_min, from.t_max[i] = ray.t_max;
      from.all_depart &= ray.departure != nullptr;
      start_on[i] = ray.leaving_until == R3::infinity ? ray.leaving : -1, end_on[i] = ray.reaching;
    }
  }

  /// Prepares the rays that fill the lanes, starting with number i; returns false if one of them is unusual.
  HWY_INLINE bool BeginLanes(const Coordinates& coordinates, double padding_per_distance, SceneRays& from,
                             std::size_t i) {
    constexpr double most_heading = 0x1p400;  // keeps per_t in range
    static_assert(2 * most_heading * most_scale < most_per_t);
    const PacketDoubles d;
    const hn::RebindToUnsigned<PacketDoubles> bits;
    const hn::Rebind<float, PacketDoubles> f;
    const double center[3] = {coordinates.center.x, coordinates.center.y, coordinates.center.z};
    const auto scale = hn::Set(d, coordinates.scale);
    const auto largest = [&](const DoubleEach* v) {
      return hn::Max(hn::Abs(hn::Load(d, v[0] + i)),
                     hn::Max(hn::Abs(hn::Load(d, v[1] + i)), hn::Abs(hn::Load(d, v[2] + i))));
    };
    const auto padding = hn::Mul(hn::Mul(hn::Set(d, padding_per_distance), largest(from.origin)), scale);
    const auto steepest = largest(from.direction);
    const auto exponent = hn::ShiftRight<52>(hn::BitCast(bits, steepest));
    const auto power = hn::ShiftLeft<52>(hn::Sub(hn::Set(bits, 2046), exponent));
    const auto inverse_power = hn::BitCast(d, hn::Sub(hn::Set(bits, std::uint64_t{2046} << 52), power));
    for (int axis = 0; axis < 3; ++axis) {
      const auto start = hn::Mul(scale, hn::Sub(hn::Load(d, from.origin[axis] + i), hn::Set(d, center[axis])));
      hn::Store(start, d, from.origin[axis] + i);
      hn::Store(hn::DemoteTo(f, start), f, origin[axis] + i);
      hn::Store(hn::DemoteTo(f, hn::Mul(hn::BitCast(d, power), hn::Load(d, from.direction[axis] + i))), f,
                direction[axis] + i);
    }
    const auto sum = [&](const DoubleEach* v) {
      return hn::Add(hn::Load(d, v[0] + i), hn::Add(hn::Load(d, v[1] + i), hn::Load(d, v[2] + i)));
    };
    const auto far = largest(from.origin);
    const auto reach = hn::Add(hn::MulAdd(hn::Set(d, translation_error), far, hn::Add(hn::Set(d, 1), far)),
                               hn::Mul(padding, hn::Set(d, 1 / static_cast<double>(relative_plane_error))));
    const auto along = hn::Mul(scale, inverse_power);
    hn::Store(along, d, per_t + i);
    const auto t_min = hn::Load(d, from.t_min + i), t_max = hn::Load(d, from.t_max + i);
    const auto departure = hn::Mul(t_min, hn::Set(d, -R3::departure_end));
    SetErrorBounds(hn::DemoteTo(f, reach), hn::DemoteTo(f, hn::Mul(t_max, along)),
                   hn::DemoteTo(f, hn::Mul(departure, along)), i);
    const auto begin_at_once = hn::And(hn::Ge(t_min, hn::Set(d, from.LeastTMin())), hn::Le(t_min, hn::Zero(d)));
    const auto head_somewhere =
        hn::And(hn::Lt(steepest, hn::Set(d, most_heading)), hn::Gt(steepest, hn::Set(d, 1 / most_heading)));
    const auto is_near =
        hn::And(hn::Le(far, hn::Add(hn::Set(d, near_enough), padding)), hn::Lt(reach, hn::Set(d, most_reach)));
    // Maxima may lose NaN, but sums do not; infinite numbers are out of range above.
    const auto numbers = hn::Add(sum(from.origin), sum(from.direction));
    const auto is_ray = hn::And(hn::Eq(numbers, numbers), hn::Lt(t_min, t_max));
    return hn::AllTrue(d, hn::And(hn::And(begin_at_once, is_ray), hn::And(head_somewhere, is_near)));
  }

  template <typename V>
  HWY_INLINE void SetErrorBounds(V r, V end, V departure, std::size_t i) {
    const hn::Rebind<float, PacketDoubles> f;
    const auto error = hn::Mul(hn::Set(f, relative_plane_error), r);
    hn::Store(error, f, plane_error + i);
    hn::Store(hn::Add(departure, error), f, certain_from + i);
    hn::Store(hn::Mul(hn::Set(f, relative_edge_error), r), f, edge_error + i);
    hn::Store(hn::Mul(hn::Set(f, relative_height_error), hn::Add(r, hn::Set(f, 1))), f, height_error + i);
    hn::Store(hn::MulAdd(end, hn::Set(f, rounded_up), error), f, limit + i);
  }

  HWY_INLINE void Invert(int axis) {
    const PacketFloats f;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
      const auto begin = hn::Load(f, origin[axis] + i), along = hn::Load(f, direction[axis] + i);
      const auto steep = hn::CopySign(hn::Max(hn::Abs(along), hn::Set(f, flattest)), along);
      const auto slope = hn::Div(hn::Set(f, 1), steep), outward = hn::CopySign(hn::Load(f, plane_error + i), along);
      hn::Store(slope, f, inverse[axis] + i);
      hn::Store(hn::Mul(hn::Add(begin, outward), slope), f, near_shift[axis] + i);
      hn::Store(hn::Mul(hn::Sub(begin, outward), slope), f, far_shift[axis] + i);
    }
  }
};

/// One ray of a packet with the interface of a TraversalRay, read in place.
struct PacketRay {
  struct Each {
    const FloatEach* each;
    int i;
    HWY_INLINE float operator[](int axis) const { return each[axis][i]; }
  };
  Each origin, direction, inverse, near_shift, far_shift;
  float plane_error, certain_from, edge_error, height_error;

  HWY_INLINE PacketRay(const Packet& packet, int i)
      : origin{packet.origin, i},
        direction{packet.direction, i},
        inverse{packet.inverse, i},
        near_shift{packet.near_shift, i},
        far_shift{packet.far_shift, i},
        plane_error(packet.plane_error[i]),
        certain_from(packet.certain_from[i]),
        edge_error(packet.edge_error[i]),
        height_error(packet.height_error[i]),
        packet_(packet) {}

  HWY_INLINE std::int32_t DownwardMask(int axis) const { return std::bit_cast<std::int32_t>(direction[axis]) >> 31; }
  HWY_INLINE float Distance(double t) const { return packet_.Distance(direction.i, t); }

 private:
  const Packet& packet_;
};

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
