// Rays that go nearly the same way, through a tree together: included once for each instruction set.

#if defined(RAY_ACCELERATE_BVH_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_BVH_PACKET_INL_H_
#undef RAY_ACCELERATE_BVH_PACKET_INL_H_
#else
#define RAY_ACCELERATE_BVH_PACKET_INL_H_
#endif

#include <new>
#include <span>
#include <type_traits>

#include "source/accelerate/wide/Walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

inline constexpr int most_together = 16;

using Together = hn::CappedTag<float, most_together>;
using TogetherDoubles = hn::CappedTag<double, most_together>;

/// One number of each ray.
using FloatEach = float[most_together];
using DoubleEach = double[most_together];

/// The probes of several rays side by side, and what encloses them all.
struct Packet {
  alignas(64) FloatEach origin[3], direction[3], inverse[3], near_shift[3], far_shift[3];
  alignas(64) FloatEach slack, slack_of_edges, slack_of_height;
  alignas(64) FloatEach limit;  // below 0 for a ray that wants nothing any more
  alignas(64) DoubleEach per_t;
  // Of all rays: where they begin, moved outward, the side that is farther from near planes first; their inverse
  // directions; and the near planes in Node::plane, in floats.
  float back[3], front[3], least_inverse[3], most_inverse[3];
  std::uint32_t planes[3];

  float Distance(int i, double t) const { return static_cast<float>(t * per_t[i]) * rounded_up + slack[i]; }

  /// TraversalRay's computations, for all rays at once. False when one of them is out of the ordinary or looks into
  /// another octant than the rest: then they have to go alone.
  HWY_INLINE bool Begin(const Coordinates& place, double pad_per_distance, std::span<const R3::Ray> rays) {
    constexpr double most_heading = 0x1p400;  // so that per_t is in range
    static_assert(2 * most_heading * most_scale < most_per_t);
    alignas(64) DoubleEach from[3], heading[3], t_max;
    bool all_begin_at_0 = true;
    for (std::size_t i = 0; i < most_together; ++i) {
      const R3::Ray& ray = rays[std::min(i, rays.size() - 1)];
      from[0][i] = ray.origin.x, from[1][i] = ray.origin.y, from[2][i] = ray.origin.z;
      heading[0][i] = ray.direction.x, heading[1][i] = ray.direction.y, heading[2][i] = ray.direction.z;
      t_max[i] = ray.t_max;
      all_begin_at_0 = all_begin_at_0 && ray.t_min == 0;
    }
    if (!all_begin_at_0 || !(place.scale <= most_scale && place.scale >= 1 / most_scale)) return false;

    const TogetherDoubles d;
    const hn::RebindToUnsigned<TogetherDoubles> bits;
    const hn::Rebind<float, TogetherDoubles> f;
    const double center[3] = {place.center.x, place.center.y, place.center.z};
    const auto scale = hn::Set(d, place.scale);
    bool is_ordinary = true;
    for (std::size_t i = 0; i < most_together; i += hn::Lanes(d)) {
      const auto largest = [&](const DoubleEach* v) {
        return hn::Max(hn::Abs(hn::Load(d, v[0] + i)),
                       hn::Max(hn::Abs(hn::Load(d, v[1] + i)), hn::Abs(hn::Load(d, v[2] + i))));
      };
      const auto more = hn::Mul(hn::Mul(hn::Set(d, pad_per_distance), largest(from)), scale);
      const auto steepest = largest(heading);
      const auto exponent = hn::ShiftRight<52>(hn::BitCast(bits, steepest));
      const auto power = hn::ShiftLeft<52>(hn::Sub(hn::Set(bits, 2046), exponent));
      const auto inverse_power = hn::BitCast(d, hn::Sub(hn::Set(bits, std::uint64_t{2046} << 52), power));
      for (int axis = 0; axis < 3; ++axis) {
        const auto start = hn::Mul(scale, hn::Sub(hn::Load(d, from[axis] + i), hn::Set(d, center[axis])));
        hn::Store(start, d, from[axis] + i);
        hn::Store(hn::DemoteTo(f, start), f, origin[axis] + i);
        hn::Store(hn::DemoteTo(f, hn::Mul(hn::BitCast(d, power), hn::Load(d, heading[axis] + i))), f,
                  direction[axis] + i);
      }
      const auto far = largest(from);
      const auto reach = hn::Add(hn::MulAdd(hn::Set(d, slack_of_moving), far, hn::Add(hn::Set(d, 1), far)),
                                 hn::Mul(more, hn::Set(d, 1 / static_cast<double>(plane_slack))));
      const auto along = hn::Mul(scale, inverse_power);
      hn::Store(along, d, per_t + i);
      const auto r = hn::DemoteTo(f, reach);
      const auto pad = hn::Mul(hn::Set(f, pad_of_boxes), r);
      hn::Store(pad, f, slack + i);
      hn::Store(hn::Mul(hn::Set(f, edge_slack), r), f, slack_of_edges + i);
      hn::Store(hn::Mul(hn::Set(f, height_slack), hn::Add(r, hn::Set(f, 1))), f, slack_of_height + i);
      hn::Store(hn::MulAdd(hn::DemoteTo(f, hn::Mul(hn::Load(d, t_max + i), along)), hn::Set(f, rounded_up), pad), f,
                limit + i);
      const auto is_fine =
          hn::And(hn::And(hn::Lt(steepest, hn::Set(d, most_heading)), hn::Gt(steepest, hn::Set(d, 1 / most_heading))),
                  hn::And(hn::Le(far, hn::Add(hn::Set(d, near_enough), more)), hn::Lt(reach, hn::Set(d, most_reach))));
      is_ordinary = is_ordinary && hn::AllTrue(d, is_fine);
    }
    if (!is_ordinary) return false;
    for (std::size_t i = rays.size(); i < most_together; ++i) limit[i] = -1;
    return Enclose();
  }

  /// The probe of one ray, for when it goes alone.
  HWY_INLINE TraversalRay Alone(int i) const {
    TraversalRay probe;
    for (int axis = 0; axis < 3; ++axis) {
      probe.origin[axis] = origin[axis][i], probe.direction[axis] = direction[axis][i];
      probe.inverse[axis] = inverse[axis][i];
      probe.near_shift[axis] = near_shift[axis][i], probe.far_shift[axis] = far_shift[axis][i];
    }
    probe.signs = std::bit_cast<Whole4>(probe.direction);
    probe.slack = slack[i], probe.slack_of_edges = slack_of_edges[i], probe.slack_of_height = slack_of_height[i];
    probe.per_t = per_t[i], probe.begin = 0;
    return probe;
  }

  float LargestLimit() const {
    const Together f;
    auto most = hn::Load(f, limit);
    for (std::size_t i = hn::Lanes(f); i < most_together; i += hn::Lanes(f))
      most = hn::Max(most, hn::Load(f, limit + i));
    return hn::GetLane(hn::MaxOfLanes(f, most));
  }

  /// Which children of a node some ray may enter before `before`, as bits; and where at the earliest. Bounds of
  /// intervals: (plane - origin) / direction for all origins and directions of the packet. Its rounding, 1/2 u for the
  /// plane, u r for origin and difference and 3 u r for the product, is within each ray's slack.
  HWY_INLINE std::uint32_t Test(const Node& node, float before, float* HWY_RESTRICT entries) const {
    const Lanes lanes;
    std::uint32_t reached = 0;
    for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
      Floats entry = hn::Zero(lanes), exit = hn::Set(lanes, before);
      for (int axis = 0; axis < 3; ++axis) {
        const float* near = node.plane[0] + planes[axis] + i;
        const float* far = node.plane[0] + (planes[axis] ^ width) + i;
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

  /// Which rays enter a child of a node before their limits, as bits.
  HWY_INLINE std::uint32_t RaysThrough(const Node& node, int child) const {
    const Together f;
    const float* const all = node.plane[0] + child;
    std::uint32_t through = 0;
    for (std::size_t i = 0; i < most_together; i += hn::Lanes(f)) {
      auto entry = hn::Zero(f), exit = hn::Load(f, limit + i);
      for (int axis = 0; axis < 3; ++axis) {
        const auto near = hn::Set(f, all[planes[axis]]), far = hn::Set(f, all[planes[axis] ^ width]);
        const auto slope = hn::Load(f, inverse[axis] + i);
        entry = hn::Max(entry, hn::MulSub(near, slope, hn::Load(f, near_shift[axis] + i)));
        exit = hn::Min(exit, hn::MulSub(far, slope, hn::Load(f, far_shift[axis] + i)));
      }
      through |= Bits(f, hn::Le(entry, exit)) << i;
    }
    return through;
  }

 private:
  HWY_INLINE bool Enclose() {
    const Together f;
    const auto load = [&](const FloatEach& each, std::size_t i) { return hn::Load(f, each + i); };
    for (int axis = 0; axis < 3; ++axis) {
      auto low = hn::Set(f, std::numeric_limits<float>::infinity()), high = hn::Neg(low), least = low, most = high;
      for (std::size_t i = 0; i < most_together; i += hn::Lanes(f)) {
        const auto begin = load(origin[axis], i), pad = load(slack, i), along = load(direction[axis], i);
        const auto steep = hn::CopySign(hn::Max(hn::Abs(along), hn::Set(f, flattest)), along);
        const auto slope = hn::Div(hn::Set(f, 1), steep), outward = hn::CopySign(pad, along);
        hn::Store(slope, f, inverse[axis] + i);
        hn::Store(hn::Mul(hn::Add(begin, outward), slope), f, near_shift[axis] + i);
        hn::Store(hn::Mul(hn::Sub(begin, outward), slope), f, far_shift[axis] + i);
        low = hn::Min(low, hn::Sub(begin, pad)), high = hn::Max(high, hn::Add(begin, pad));
        least = hn::Min(least, slope), most = hn::Max(most, slope);
      }
      back[axis] = hn::GetLane(hn::MinOfLanes(f, low)), front[axis] = hn::GetLane(hn::MaxOfLanes(f, high));
      least_inverse[axis] = hn::GetLane(hn::MinOfLanes(f, least));
      most_inverse[axis] = hn::GetLane(hn::MaxOfLanes(f, most));
      if (least_inverse[axis] < 0 && most_inverse[axis] > 0) return false;
      const bool is_downward = most_inverse[axis] < 0;
      planes[axis] = 2 * width * static_cast<std::uint32_t>(axis) + (is_downward ? width : 0);
      if (is_downward) std::swap(back[axis], front[axis]);
    }
    return true;
  }
};

template <typename Work>
HWY_INLINE void ForEachBit(std::uint32_t bits, const Work& work) {
  for (; bits != 0; bits &= bits - 1) work(std::countr_zero(bits));
}

/// Walks with a packet. Whether a node is reached is asked of the whole packet, eight children at a time; whether a
/// child is, of its rays, all at a time; and so are triangles. Where few rays go on, they go alone.
///   source  Wald, Slusallek, Benthin, Wagner, Interactive rendering with coherent ray tracing (2001);
///           Reshetov, Soupikov, Hurley, Multi-level ray tracing algorithm (2005), for the bounds of a packet
template <bool any>
class Convoy {
 public:
  HWY_INLINE Convoy(const TwoLevel<Tree>& forest, std::span<const R3::Ray> rays, Counts& counts)
      : forest_(forest), tree_(forest.structures[0]), rays_(rays), counts_(counts) {
    for (int i = 0; i < Size(); ++i) new (&Nearest(i)) NearestHit(*forest.world, Ray(i));
  }

  int Size() const { return static_cast<int>(rays_.size()); }
  const std::optional<WorldHit>& Best(int i) { return Nearest(i).Best(); }
  bool IsAnswered(int i) const { return answered_ >> i & 1; }

  HWY_INLINE void Search() {
    if (Size() > few && packet_.Begin(tree_.coordinates, tree_.space.PadPerDistance(), rays_)) {
      if constexpr (any) {
        for (int i = 0; i < most_together; ++i) limit_for_certain_[i] = packet_.limit[i] - 4 * packet_.slack[i];
      }
      Walk();
      Finish();
    } else {
      for (int i = 0; i < Size(); ++i)
        if (HWY_NAMESPACE::Search<any>(forest_, tree_, Ray(i), DistanceInWorld(i), std::nullopt, Nearest(i), counts_))
          answered_ |= std::uint32_t{1} << i;
    }
  }

 private:
  static constexpr int few = 2;  // rays that are faster alone than together
  static constexpr int most_kept = 8;
  struct GpuCache {
    std::uint32_t item;
    float nearest;
  };

  const R3::Ray& Ray(int i) const { return rays_[static_cast<std::size_t>(i)]; }
  double DistanceInWorld(int i) const { return MaxComponent(Abs(FromOrigin(Ray(i).origin))); }
  NearestHit& Nearest(int i) { return reinterpret_cast<NearestHit*>(nearest_)[i]; }
  ExactTriangleTest<Tree> DeciderOf(int i) { return {forest_, tree_, Ray(i), std::nullopt, Nearest(i), counts_}; }

  HWY_INLINE void Walk() {
    struct Waiting {
      std::uint64_t entry_and_lane;
      const Node* parent;
    };
    Waiting stack[bvh::most_depth * width];
    Waiting* top = stack;
    std::uint32_t child = tree_.root, rays = (std::uint32_t{1} << Size()) - 1;
    std::uint64_t nodes = 0, leaves = 0;
    float limit = packet_.LargestLimit();

    while (true) {
      const auto kind = Child::KindOf(child);
      if (kind == Child::Kind::node && std::popcount(rays) > few) {
        ++nodes;
        const Node& node = tree_.At<Node>(child);
        alignas(32) float entries[width];
        Waiting* const base = top;
        ForEachBit(packet_.Test(node, limit, entries), [&](int i) HWY_ATTR {
          const Waiting next{Wait(entries[i], static_cast<std::uint32_t>(i)), &node};
          if (tree_.is_large) Fetch(tree_, node.child[i]);
          Waiting* place = top++;
          for (; place != base && place[-1].entry_and_lane < next.entry_and_lane; --place) *place = place[-1];
          *place = next;
        });
      } else if (kind != Child::Kind::nothing) {
        ++leaves;
        if (kind == Child::Kind::triangles && std::popcount(rays) > few)
          AskBlock(tree_.At<TriangleBlock>(child), rays);
        else if (kind == Child::Kind::item)
          ForEachBit(rays, [&](int i) HWY_ATTR { AskItem(i, Child::Index(child)); });
        else
          ForEachBit(rays, [&](int i) HWY_ATTR { GoAlone(i, child); });
        limit = packet_.LargestLimit();
        if (limit < 0) break;
      }
      do {
        if (top == stack) goto done;
        --top;
        rays = 0;
        if (EntryOf(top->entry_and_lane) > limit) continue;
        const int lane = static_cast<int>(static_cast<std::uint32_t>(top->entry_and_lane));
        rays = packet_.RaysThrough(*top->parent, lane);
        child = top->parent->child[lane];
      } while (rays == 0);
    }
  done:
    counts_.node_visits += nodes + leaves;
    counts_.box_tests += nodes * width;
  }

  /// One ray into a child of whatever kind.
  HWY_NOINLINE void GoAlone(int i, std::uint32_t child) {
    const TraversalRay probe = packet_.Alone(i);
    LeafVisitor<any, Tree> asker(forest_, tree_, Ray(i), probe, DistanceInWorld(i), std::nullopt, Nearest(i), counts_);
    asker.limit = std::min(asker.limit, packet_.limit[i]);
    WalkFrom<any>(child, tree_, BoxProbe(probe), asker, counts_);
    asker.Finish();
    packet_.limit[i] = asker.limit;
    if (asker.is_answered) Answer(i);
  }

  void AskItem(int i, std::uint32_t item) {
    if (HWY_NAMESPACE::AskItem<any>(forest_, tree_, item, Ray(i), DistanceInWorld(i), Nearest(i), counts_))
      Answer(i);
    else
      packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
  }

  void Answer(int i) {
    answered_ |= std::uint32_t{1} << i;
    packet_.limit[i] = -1;
  }

  HWY_INLINE void AskBlock(const TriangleBlock& block, std::uint32_t rays) {
    const Together f;
    const auto set = [&](float x) { return hn::Set(f, x); };
    alignas(32) float shape[11][width];
    const Lanes lanes;
    for (std::size_t k = 0; k < width; k += hn::Lanes(lanes)) {
      const TriangleLanes<Lanes> t = LoadTriangles(lanes, block, k);
      const Floats all[] = {t.edge1_x,  t.edge1_y,  t.edge1_z,  t.edge2_x, t.edge2_y, t.edge2_z,
                            t.normal_x, t.normal_y, t.normal_z, t.edges,   t.area};
      for (std::size_t part = 0; part < 11; ++part) hn::Store(all[part], lanes, shape[part] + k);
    }
    for (int k = 0; k < width && block.corner[0][k] == block.corner[0][k]; ++k) {
      const auto part = [&](int p) { return set(shape[p][k]); };
      const TriangleLanes<Together> triangle{part(0), part(1), part(2), part(3), part(4), part(5),
                                             part(6), part(7), part(8), part(9), part(10)};
      for (std::size_t i = 0; i < most_together; i += hn::Lanes(f)) {
        const auto load = [&](const FloatEach& each) { return hn::Load(f, each + i); };
        const auto to_corner = [&](int axis) {
          return hn::Sub(set(block.corner[axis][k]), load(packet_.origin[axis]));
        };
        const auto limit = load(packet_.limit);
        const RayLanes<Together> ray{load(packet_.direction[0]),
                                     load(packet_.direction[1]),
                                     load(packet_.direction[2]),
                                     load(packet_.slack),
                                     load(packet_.slack_of_edges),
                                     load(packet_.slack_of_height),
                                     limit};
        TriangleMask<Together> verdict;
        if (!TestLanes(f, triangle, to_corner(0), to_corner(1), to_corner(2), ray, verdict)) continue;
        if constexpr (!doubles_decide) verdict.maybe = verdict.certain;
        const std::uint32_t maybe = Bits(f, verdict.maybe) << i & rays;
        if constexpr (any) {
          const auto is_before = hn::Lt(verdict.farthest, load(limit_for_certain_));
          const std::uint32_t certain = Bits(f, hn::And(verdict.certain, is_before)) << i & maybe;
          ForEachBit(certain, [&](int j) { Answer(j); });
          ForEachBit(maybe & ~certain, [&](int j) HWY_ATTR {
            auto decider = DeciderOf(j);
            if (decider.Decide(decider.Find(block.item[k]))) Answer(j);
          });
        } else {
          const auto least = hn::Min(limit, verdict.farthest);
          hn::Store(hn::IfThenElse(verdict.certain, least, limit), f, packet_.limit + i);
          hn::Store(verdict.nearest, f, nearest_now_ + i);
          ForEachBit(maybe, [&](int j) HWY_ATTR { Keep(j, block.item[k]); });
        }
      }
    }
  }

  HWY_INLINE void Keep(int i, std::uint32_t item) {
    if (kept_count_[i] == most_kept) Decide(i);
    kept_[i][kept_count_[i]++] = {item, nearest_now_[i]};
  }

  HWY_INLINE void Decide(int i) {
    auto decider = DeciderOf(i);
    while (kept_count_[i] > 0) {
      const GpuCache& kept = kept_[i][--kept_count_[i]];
      if (!(kept.nearest <= packet_.limit[i])) continue;
      const auto place = decider.Find(kept.item);
      if constexpr (!doubles_decide) {
        Nearest(i).Offer({{kept.nearest / packet_.per_t[i], 0, 0, 0}, place.instance, place.element});
        packet_.limit[i] = kept.nearest;
      } else if (decider.Decide(place) && kept_count_[i] > 0) {
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
      }
    }
  }

  HWY_INLINE void Finish() {
    if constexpr (any) return;
    const auto each_last = [&](const auto& fetch) {
      for (int i = 0; i < Size(); ++i)
        if (kept_count_[i] > 0) fetch(DeciderOf(i).Find(kept_[i][kept_count_[i] - 1].item));
    };
    each_last([](const auto& place) { place.FetchIndices(); });
    each_last([](const auto& place) { place.FetchCorners(); });
    for (int i = 0; i < Size(); ++i) Decide(i);
  }

  const TwoLevel<Tree>& forest_;
  const Tree& tree_;
  std::span<const R3::Ray> rays_;
  Counts& counts_;
  std::uint32_t answered_ = 0;  // rays of `any` that have hit something, as bits
  Packet packet_;
  alignas(64) FloatEach limit_for_certain_, nearest_now_;
  std::uint8_t kept_count_[most_together] = {};
  GpuCache kept_[most_together][most_kept];
  static_assert(std::is_trivially_destructible_v<NearestHit>);
  alignas(NearestHit) std::byte nearest_[most_together * sizeof(NearestHit)];
};

/// FindNearest or FindAny for each of the rays: the same answers, since all ask the same doubles in the end.
template <bool any>
void FindTogether(const TwoLevel<Tree>& forest, std::span<const R3::Ray> rays,
                  std::conditional_t<any, bool, std::optional<WorldHit>>* answers, Counts& counts) {
  while (!rays.empty()) {
    Convoy<any> convoy(forest, rays.first(std::min<std::size_t>(rays.size(), most_together)), counts);
    convoy.Search();
    for (int i = 0; i < convoy.Size(); ++i) {
      if constexpr (any)
        *answers++ = convoy.IsAnswered(i);
      else
        *answers++ = convoy.Best(i);
    }
    rays = rays.subspan(static_cast<std::size_t>(convoy.Size()));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
