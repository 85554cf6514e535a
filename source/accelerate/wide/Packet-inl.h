// Packets of coherent rays through a wide tree: included once for each instruction set.

#if defined(RAY_ACCELERATE_WIDE_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_PACKET_INL_H_
#undef RAY_ACCELERATE_WIDE_PACKET_INL_H_
#else
#define RAY_ACCELERATE_WIDE_PACKET_INL_H_
#endif

#include <new>
#include <span>
#include <type_traits>

#include "source/accelerate/wide/Traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

inline constexpr int packet_size = 16;

using PacketFloats = hn::CappedTag<float, packet_size>;
using PacketDoubles = hn::CappedTag<double, packet_size>;

/// One number of each ray.
using FloatEach = float[packet_size];
using DoubleEach = double[packet_size];

/// The traversal rays of a packet side by side, and what encloses them all.
struct Packet {
  alignas(64) FloatEach origin[3], direction[3], inverse[3], near_shift[3], far_shift[3];
  alignas(64) FloatEach plane_error, edge_error, height_error;
  alignas(64) FloatEach limit;  // below 0 for a ray that wants nothing any more
  alignas(64) DoubleEach per_t;
  // Of all rays: where they begin, moved outward, the side that is farther from near planes first; their inverse
  // directions; and where in Node::planes the near ones begin.
  float back[3], front[3], least_inverse[3], most_inverse[3];
  std::uint32_t planes[3];

  float Distance(int i, double t) const { return static_cast<float>(t * per_t[i]) * rounded_up + plane_error[i]; }

  /// TraversalRay's computations, for all rays at once. False when one of them is out of the ordinary: then they have
  /// to be made ready one by one.
  HWY_INLINE bool Begin(const Coordinates& coordinates, double padding_per_distance, std::span<const R3::Ray> rays) {
    SceneRays from;
    const bool all_begin_at_0 = from.Load(rays);
    if (!all_begin_at_0 || !(coordinates.scale <= most_scale && coordinates.scale >= 1 / most_scale)) return false;
    bool is_ordinary = true;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(PacketDoubles()))
      is_ordinary &= BeginLanes(coordinates, padding_per_distance, from, i);
    if (!is_ordinary) return false;
    for (std::size_t i = rays.size(); i < packet_size; ++i) limit[i] = -1;
    for (int axis = 0; axis < 3; ++axis) Invert(axis);
    return true;
  }

  /// Finds what encloses all rays. False when one of them looks into another octant than the rest: then they go one by
  /// one.
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

  float LargestLimit() const {
    const PacketFloats f;
    auto most = hn::Load(f, limit);
    for (std::size_t i = hn::Lanes(f); i < packet_size; i += hn::Lanes(f)) most = hn::Max(most, hn::Load(f, limit + i));
    return hn::GetLane(hn::MaxOfLanes(f, most));
  }

  /// Which children of a node some ray may enter before `before`, as bits; and where at the earliest. Bounds of
  /// intervals: (plane - origin) / direction for all origins and directions of the packet. Its rounding, 1/2 u for the
  /// plane, u r for origin and difference and 3 u r for the product, is within each ray's error bound.
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

  /// Which rays enter a child of a node before their limits, as bits.
  HWY_INLINE std::uint32_t RaysThrough(const Node& node, int child) const {
    const PacketFloats f;
    const float* const all = node.planes + child;
    std::uint32_t through = 0;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
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
  struct SceneRays {
    alignas(64) DoubleEach origin[3], direction[3], t_max;

    /// Lanes without a ray repeat the last one. Returns whether all begin at t = 0.
    HWY_INLINE bool Load(std::span<const R3::Ray> rays) {
      bool all_begin_at_0 = true;
      for (std::size_t i = 0; i < packet_size; ++i) {
        const R3::Ray& ray = rays[std::min(i, rays.size() - 1)];
        origin[0][i] = ray.origin.x, origin[1][i] = ray.origin.y, origin[2][i] = ray.origin.z;
        direction[0][i] = ray.direction.x, direction[1][i] = ray.direction.y, direction[2][i] = ray.direction.z;
        t_max[i] = ray.t_max;
        all_begin_at_0 = all_begin_at_0 && ray.t_min == 0;
      }
      return all_begin_at_0;
    }
  };

  /// The rays from number i on that fill the lanes; false when one of them is out of the ordinary.
  HWY_INLINE bool BeginLanes(const Coordinates& coordinates, double padding_per_distance, SceneRays& from,
                             std::size_t i) {
    constexpr double most_heading = 0x1p400;  // so that per_t is in range
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
    const auto far = largest(from.origin);
    const auto reach = hn::Add(hn::MulAdd(hn::Set(d, translation_error), far, hn::Add(hn::Set(d, 1), far)),
                               hn::Mul(padding, hn::Set(d, 1 / static_cast<double>(relative_plane_error))));
    const auto along = hn::Mul(scale, inverse_power);
    hn::Store(along, d, per_t + i);
    SetErrorBounds(hn::DemoteTo(f, reach), hn::DemoteTo(f, hn::Mul(hn::Load(d, from.t_max + i), along)), i);
    return hn::AllTrue(
        d, hn::And(
               hn::And(hn::Lt(steepest, hn::Set(d, most_heading)), hn::Gt(steepest, hn::Set(d, 1 / most_heading))),
               hn::And(hn::Le(far, hn::Add(hn::Set(d, near_enough), padding)), hn::Lt(reach, hn::Set(d, most_reach)))));
  }

  template <typename V>
  HWY_INLINE void SetErrorBounds(V r, V end, std::size_t i) {
    const hn::Rebind<float, PacketDoubles> f;
    const auto error = hn::Mul(hn::Set(f, relative_plane_error), r);
    hn::Store(error, f, plane_error + i);
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

/// One ray of a packet as a TraversalRay, where it lies.
struct PacketRay {
  struct Each {
    const FloatEach* each;
    int i;
    HWY_INLINE float operator[](int axis) const { return each[axis][i]; }
  };
  Each origin, direction, inverse, near_shift, far_shift;
  float plane_error, edge_error, height_error;

  HWY_INLINE PacketRay(const Packet& packet, int i)
      : origin{packet.origin, i},
        direction{packet.direction, i},
        inverse{packet.inverse, i},
        near_shift{packet.near_shift, i},
        far_shift{packet.far_shift, i},
        plane_error(packet.plane_error[i]),
        edge_error(packet.edge_error[i]),
        height_error(packet.height_error[i]),
        packet_(packet) {}

  HWY_INLINE bool IsDownward(int axis) const { return std::bit_cast<std::int32_t>(direction[axis]) < 0; }
  HWY_INLINE float Distance(double t) const { return packet_.Distance(direction.i, t); }

 private:
  const Packet& packet_;
};

template <typename Work>
HWY_INLINE void ForEachBit(std::uint32_t bits, const Work& work) {
  for (; bits != 0; bits &= bits - 1) work(std::countr_zero(bits));
}

/// Packet traversal. Whether a node is reached is asked of the whole packet, eight children at a time; whether a child
/// is, of its rays, all at a time; and so are triangles. Where few rays go on, they go alone; and so do all of a packet
/// that is not coherent, made ready together nevertheless.
///   source  Wald, Slusallek, Benthin, Wagner, Interactive rendering with coherent ray tracing (2001);
///           Reshetov, Soupikov, Hurley, Multi-level ray tracing algorithm (2005), for the bounds of a packet
template <bool any>
class PacketTraversal {
 public:
  HWY_INLINE PacketTraversal(const TwoLevel<Tree>& two_level, std::span<const R3::Ray> rays, Counts& counts)
      : two_level_(two_level), tree_(two_level.structures[0]), rays_(rays), counts_(counts) {
    for (int i = 0; i < Size(); ++i) new (&Nearest(i)) NearestHit(*two_level.world, Ray(i));
  }

  int Size() const { return static_cast<int>(rays_.size()); }
  const std::optional<WorldHit>& Best(int i) { return Nearest(i).Best(); }
  bool IsAnswered(int i) const { return answered_ >> i & 1; }

  HWY_INLINE void Search() {
    if (Size() > few_rays && packet_.Begin(tree_.coordinates, tree_.primitives.PaddingPerDistance(), rays_)) {
      if (!packet_.Enclose()) {
        for (int i = 0; i < Size(); ++i) TraverseAlone(i, tree_.root);
        return;
      }
      if constexpr (any) {
        for (int i = 0; i < packet_size; ++i) limit_for_certain_[i] = packet_.limit[i] - 4 * packet_.plane_error[i];
      }
      Traverse();
      TestAllCandidates();
    } else {
      for (int i = 0; i < Size(); ++i)
        if (HWY_NAMESPACE::Search<any>(two_level_, tree_, Ray(i), DistanceInWorld(i), std::nullopt, Nearest(i),
                                       counts_))
          answered_ |= std::uint32_t{1} << i;
    }
  }

 private:
  static constexpr int few_rays = 2;  // rays that are faster alone than together
  static constexpr int most_candidates = 8;
  struct Candidate {
    std::uint32_t primitive;
    float nearest;
  };

  const R3::Ray& Ray(int i) const { return rays_[static_cast<std::size_t>(i)]; }
  double DistanceInWorld(int i) const { return MaxComponent(Abs(FromOrigin(Ray(i).origin))); }
  NearestHit& Nearest(int i) { return reinterpret_cast<NearestHit*>(nearest_)[i]; }
  ExactTriangleTest<Tree> ExactTestOf(int i) { return {two_level_, tree_, Ray(i), std::nullopt, Nearest(i), counts_}; }

  struct StackEntry {
    std::uint64_t distance_and_lane;  // PackEntry
    const Node* parent;
  };

  HWY_INLINE void Traverse() {
    StackEntry stack[wide::most_depth * width];
    StackEntry* top = stack;
    std::uint32_t child = tree_.root, rays = (std::uint32_t{1} << Size()) - 1;
    std::uint64_t nodes = 0, leaves = 0;
    float limit = packet_.LargestLimit();

    while (true) {
      const auto kind = Child::KindOf(child);
      if (kind == Child::Kind::node && std::popcount(rays) > few_rays) {
        ++nodes;
        top = PushSorted(tree_.At<Node>(child), limit, top);
      } else if (!Child::IsNothing(child)) {
        ++leaves;
        VisitLeaf(child, rays);
        limit = packet_.LargestLimit();
        if (limit < 0) break;
      }
      do {
        if (top == stack) goto done;
        --top;
        rays = 0;
        if (DistanceOf(top->distance_and_lane) > limit) continue;
        const int lane = static_cast<int>(static_cast<std::uint32_t>(top->distance_and_lane));
        rays = packet_.RaysThrough(*top->parent, lane);
        child = top->parent->child[lane];
      } while (rays == 0);
    }
  done:
    counts_.node_visits += nodes + leaves;
    counts_.box_tests += nodes * width;
  }

  /// The children that the packet reaches, nearest on top; returns the new top.
  HWY_INLINE StackEntry* PushSorted(const Node& node, float limit, StackEntry* const base) {
    StackEntry* top = base;
    alignas(32) float distances[width];
    ForEachBit(packet_.Test(node, limit, distances), [&](int i) HWY_ATTR {
      const StackEntry next{PackEntry(distances[i], static_cast<std::uint32_t>(i)), &node};
      if (tree_.is_large) Prefetch(tree_, node.child[i]);
      StackEntry* to = top++;
      for (; to != base && to[-1].distance_and_lane < next.distance_and_lane; --to) *to = to[-1];
      *to = next;
    });
    return top;
  }

  /// A leaf, or a node that few rays reach.
  HWY_INLINE void VisitLeaf(std::uint32_t child, std::uint32_t rays) {
    const auto kind = Child::KindOf(child);
    if (kind == Child::Kind::triangles && std::popcount(rays) > few_rays)
      VisitTriangles(tree_.At<TriangleBlock>(child), rays);
    else if (kind == Child::Kind::sphere)
      ForEachBit(rays, [&](int i) HWY_ATTR { VisitSphere(i, tree_.At<SphereLeaf>(child)); });
    else if (kind == Child::Kind::primitive)
      ForEachBit(rays, [&](int i) HWY_ATTR { VisitPrimitive(i, Child::Index(child)); });
    else
      ForEachBit(rays, [&](int i) HWY_ATTR { TraverseAlone(i, child); });
  }

  /// One ray into a child of whatever kind.
  HWY_NOINLINE void TraverseAlone(int i, std::uint32_t child) {
    const PacketRay ray(packet_, i);
    LeafVisitor<any, Tree, PacketRay> visitor(two_level_, tree_, Ray(i), ray, DistanceInWorld(i), std::nullopt,
                                              Nearest(i), counts_);
    visitor.limit = std::min(visitor.limit, packet_.limit[i]);
    TraverseFrom<any>(child, tree_, NodeRay(ray), visitor, counts_);
    if constexpr (!any) visitor.TestCandidates();
    packet_.limit[i] = visitor.limit;
    if (visitor.is_answered) Answer(i);
  }

  HWY_INLINE void VisitSphere(int i, const SphereLeaf& leaf) {
    if (!TestSphere<any>(leaf, Ray(i), Nearest(i), counts_)) return;
    if constexpr (any)
      Answer(i);
    else
      packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
  }

  void VisitPrimitive(int i, std::uint32_t primitive) {
    if (TestPrimitive<any>(two_level_, tree_, primitive, Ray(i), DistanceInWorld(i), Nearest(i), counts_))
      Answer(i);
    else
      packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
  }

  void Answer(int i) {
    answered_ |= std::uint32_t{1} << i;
    packet_.limit[i] = -1;
  }

  /// The triangles of a block, ready to be broadcast one after the other.
  struct TriangleArrays {
    alignas(32) float numbers[11][width];

    HWY_INLINE explicit TriangleArrays(const TriangleBlock& block) {
      const Lanes d;
      for (std::size_t k = 0; k < width; k += hn::Lanes(d)) {
        const TriangleLanes<Lanes> t = LoadTriangles(d, block, k);
        const Floats all[] = {t.edge1_x,  t.edge1_y,  t.edge1_z,  t.edge2_x, t.edge2_y, t.edge2_z,
                              t.normal_x, t.normal_y, t.normal_z, t.edges,   t.area};
        for (std::size_t n = 0; n < 11; ++n) hn::Store(all[n], d, numbers[n] + k);
      }
    }
    HWY_INLINE TriangleLanes<PacketFloats> Broadcast(int k) const {
      const auto set = [&](int n) { return hn::Set(PacketFloats(), numbers[n][k]); };
      return {set(0), set(1), set(2), set(3), set(4), set(5), set(6), set(7), set(8), set(9), set(10)};
    }
  };

  HWY_INLINE void VisitTriangles(const TriangleBlock& block, std::uint32_t rays) {
    const TriangleArrays arrays(block);
    for (int k = 0; k < width && block.corner[0][k] == block.corner[0][k]; ++k) {
      const TriangleLanes<PacketFloats> triangle = arrays.Broadcast(k);
      for (std::size_t i = 0; i < packet_size; i += hn::Lanes(PacketFloats()))
        TestTriangle(block, k, triangle, i, rays);
    }
  }

  /// One triangle against those of `rays` that fill the lanes from number i on.
  HWY_INLINE void TestTriangle(const TriangleBlock& block, int k, const TriangleLanes<PacketFloats>& triangle,
                               std::size_t i, std::uint32_t rays) {
    const PacketFloats f;
    const auto load = [&](const FloatEach& each) { return hn::Load(f, each + i); };
    const auto to_corner = [&](int axis) {
      return hn::Sub(hn::Set(f, block.corner[axis][k]), load(packet_.origin[axis]));
    };
    const auto limit = load(packet_.limit);
    const RayLanes<PacketFloats> ray{load(packet_.direction[0]),
                                     load(packet_.direction[1]),
                                     load(packet_.direction[2]),
                                     load(packet_.plane_error),
                                     load(packet_.edge_error),
                                     load(packet_.height_error),
                                     limit};
    TriangleMask<PacketFloats> mask;
    if (!TestLanes(f, triangle, to_corner(0), to_corner(1), to_corner(2), ray, mask)) return;
    const std::uint32_t maybe = Bits(f, mask.maybe) << i & rays;
    if constexpr (any) {
      const auto is_before = hn::Lt(mask.farthest, load(limit_for_certain_));
      const std::uint32_t certain = Bits(f, hn::And(mask.certain, is_before)) << i & maybe;
      ForEachBit(certain, [&](int j) { Answer(j); });
      ForEachBit(maybe & ~certain, [&](int j) HWY_ATTR {
        auto exact_test = ExactTestOf(j);
        if (exact_test.Test(exact_test.Locate(block.primitive[k]))) Answer(j);
      });
    } else {
      const auto least = hn::Min(limit, mask.farthest);
      hn::Store(hn::IfThenElse(mask.certain, least, limit), f, packet_.limit + i);
      hn::Store(mask.nearest, f, nearest_now_ + i);
      ForEachBit(maybe, [&](int j) HWY_ATTR { Keep(j, block.primitive[k]); });
    }
  }

  HWY_INLINE void Keep(int i, std::uint32_t primitive) {
    if (candidate_count_[i] == most_candidates) TestCandidates(i);
    candidates_[i][candidate_count_[i]++] = {primitive, nearest_now_[i]};
  }

  HWY_INLINE void TestCandidates(int i) {
    auto exact_test = ExactTestOf(i);
    while (candidate_count_[i] > 0) {
      const Candidate& candidate = candidates_[i][--candidate_count_[i]];
      if (candidate.nearest <= packet_.limit[i] && exact_test.Test(exact_test.Locate(candidate.primitive)) &&
          candidate_count_[i] > 0)
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
    }
  }

  HWY_INLINE void TestAllCandidates() {
    if constexpr (any) return;
    const auto each_last = [&](const auto& prefetch) {
      for (int i = 0; i < Size(); ++i)
        if (candidate_count_[i] > 0) prefetch(ExactTestOf(i).Locate(candidates_[i][candidate_count_[i] - 1].primitive));
    };
    each_last([](const auto& triangle) { triangle.PrefetchIndices(); });
    each_last([](const auto& triangle) { triangle.PrefetchCorners(); });
    for (int i = 0; i < Size(); ++i) TestCandidates(i);
  }

  const TwoLevel<Tree>& two_level_;
  const Tree& tree_;
  std::span<const R3::Ray> rays_;
  Counts& counts_;
  std::uint32_t answered_ = 0;  // rays of `any` that have hit something, as bits
  Packet packet_;
  alignas(64) FloatEach limit_for_certain_, nearest_now_;
  std::uint8_t candidate_count_[packet_size] = {};
  Candidate candidates_[packet_size][most_candidates];
  static_assert(std::is_trivially_destructible_v<NearestHit>);
  alignas(NearestHit) std::byte nearest_[packet_size * sizeof(NearestHit)];
};

/// FindNearest or FindAny for each of the rays: the same answers, since the exact test decides in the end.
template <bool any>
void TracePackets(const TwoLevel<Tree>& two_level, std::span<const R3::Ray> rays,
                  std::conditional_t<any, bool, std::optional<WorldHit>>* answers, Counts& counts) {
  while (!rays.empty()) {
    PacketTraversal<any> traversal(two_level, rays.first(std::min<std::size_t>(rays.size(), packet_size)), counts);
    traversal.Search();
    for (int i = 0; i < traversal.Size(); ++i) {
      if constexpr (any)
        *answers++ = traversal.IsAnswered(i);
      else
        *answers++ = traversal.Best(i);
    }
    rays = rays.subspan(static_cast<std::size_t>(traversal.Size()));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
