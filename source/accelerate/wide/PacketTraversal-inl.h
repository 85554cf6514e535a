// Packets of rays through a wide tree. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_PACKET_TRAVERSAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_PACKET_TRAVERSAL_INL_H_
#undef RAY_ACCELERATE_WIDE_PACKET_TRAVERSAL_INL_H_
#else
#define RAY_ACCELERATE_WIDE_PACKET_TRAVERSAL_INL_H_
#endif

#include <new>
#include <span>
#include <type_traits>

#include "source/accelerate/wide/Packet-inl.h"
#include "source/accelerate/wide/PacketExact-inl.h"
#include "source/accelerate/wide/PacketSphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

template <typename Work>
HWY_INLINE void ForEachBit(std::uint32_t bits, const Work& work) {
  for (; bits != 0; bits &= bits - 1) work(std::countr_zero(bits));
}

/// Packet traversal. Eight children of a node at a time are tested against the bounds of the whole packet; then each
/// child, and each triangle, against all rays at once. If few rays remain, they continue one at a time. So do the rays
/// of a packet that is not coherent, although they are prepared together, unless the tree is so small that many of them
/// reach most of its boxes: then the boxes are tested in order.
///   source  Wald, Slusallek, Benthin, Wagner, Interactive rendering with coherent ray tracing (2001);
///           Reshetov, Soupikov, Hurley, Multi-level ray tracing algorithm (2005), for the bounds of a packet
template <bool any>
class PacketTraversal {
 public:
  /// Prepares the traversal. The nearest hits go to `hits`; with `any` that is one element, which stays empty.
  HWY_INLINE PacketTraversal(const TwoLevel<Tree>& two_level, std::span<const R3::Ray> rays,
                             std::optional<WorldHit>* hits, Counts& counts)
      : two_level_(two_level), tree_(two_level.structures[0]), rays_(rays), hits_(hits), counts_(counts) {
    if constexpr (!any)
      for (int i = 0; i < Size(); ++i) MakeNearest(i, i);
  }

  int Size() const { return static_cast<int>(rays_.size()); }
  std::uint32_t Answered() const { return answered_; }

  HWY_INLINE void Search() {
    if (Size() > few_rays && !Child::IsNothing(tree_.root) &&
        packet_.Begin(tree_.coordinates, tree_.primitives.PaddingPerDistance(), rays_)) {
      if constexpr (any) {
        constexpr auto share = static_cast<float>(end_of_certainty);
        for (int i = 0; i < packet_size; ++i)
          limit_for_certain_[i] = share * packet_.limit[i] - 4 * packet_.plane_error[i];
      }
      if (packet_.Enclose())
        Traverse();
      else if (tree_.nodes <= nodes_of_small_tree)
        VisitAll(tree_.root, AllRays());
      else
        for (int i = 0; i < Size(); ++i) TraverseAlone(i, tree_.root);
      TestAllCandidates();
    } else {
      for (int i = 0; i < Size(); ++i) SearchAlone(i);
    }
  }

 private:
  static constexpr int few_rays = 2;                     // number of rays that are faster alone than together
  static constexpr std::size_t nodes_of_small_tree = 8;  // scenes of 1 to 7 nodes gain; larger ones were not tested
  static constexpr int most_candidates = 8;
  struct Candidate {
    const TriangleBlock* block;
    std::uint32_t lane;
    float nearest;
  };

  std::uint32_t AllRays() const { return (std::uint32_t{1} << Size()) - 1; }
  const R3::Ray& Ray(int i) const { return rays_[static_cast<std::size_t>(i)]; }
  double DistanceInWorld(int i) const { return MaxComponent(Abs(FromOrigin(Ray(i).origin))); }
  NearestHit& MakeNearest(int place, int i) {
    return *new (nearest_ + place * static_cast<int>(sizeof(NearestHit)))
        NearestHit(*two_level_.world, Ray(i), hits_[place]);
  }
  /// Returns the nearest hit of a ray. With `any`, unfinished rays have none, so one object serves all.
  NearestHit& Nearest(int i) {
    if constexpr (any) return MakeNearest(0, i);
    return reinterpret_cast<NearestHit*>(nearest_)[i];
  }
  using ExactTest = ExactTriangleTest<any, Tree>;
  ExactTest ExactTestOf(int i) {
    return {two_level_, tree_, Ray(i), std::nullopt, Nearest(i), counts_};
  }

  struct StackEntry {
    std::uint64_t distance_and_lane;  // PackEntry
    const Node* parent;
  };

  void SearchAlone(int i) {
    if (!IsRay(Ray(i)))
      ++counts_.bad_rays;
    else if (HWY_NAMESPACE::Search<any>(two_level_, tree_, Ray(i), DistanceInWorld(i), std::nullopt, Nearest(i),
                                        counts_))
      answered_ |= std::uint32_t{1} << i;
  }

  HWY_INLINE void Traverse() {
    StackEntry stack[wide::most_depth * width];
    StackEntry* top = stack;
    std::uint32_t child = tree_.root, rays = AllRays();
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
        rays = packet_.template RaysThrough<true>(*top->parent, lane);
        child = top->parent->child[lane];
      } while (rays == 0);
    }
  done:
    counts_.node_visits += nodes + leaves;
    counts_.box_tests += nodes * width;
  }

  /// Visits a child that `rays` reach, and its subtree, in memory order.
  void VisitAll(std::uint32_t child, std::uint32_t rays) {
    ++counts_.node_visits;
    if (Child::KindOf(child) != Child::Kind::node || std::popcount(rays) <= few_rays) return VisitLeaf(child, rays);
    counts_.box_tests += width;
    const Node& node = tree_.At<Node>(child);
    for (int lane = 0; lane < width; ++lane) {
      if (Child::IsNothing(node.child[lane])) continue;
      const std::uint32_t through = packet_.template RaysThrough<false>(node, lane) & rays;
      if (through != 0) VisitAll(node.child[lane], through);
    }
  }

  /// Pushes the children that the packet reaches, nearest on top; returns the new top.
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

  /// Visits a leaf, or a node that few rays reach.
  HWY_INLINE void VisitLeaf(std::uint32_t child, std::uint32_t rays) {
    const auto kind = Child::KindOf(child);
    if (kind == Child::Kind::triangles && std::popcount(rays) > few_rays)
      VisitTriangles(tree_.At<TriangleBlock>(child), rays);
    else if (kind == Child::Kind::sphere)
      VisitSphere(tree_.At<SphereLeaf>(child), rays);
    else if (kind == Child::Kind::hulls && std::popcount(rays) > few_rays)
      VisitHulls(tree_.At<HullBlock>(child), rays);
    else if (kind == Child::Kind::primitive)
      VisitPrimitive(Child::Index(child), rays);
    else
      ForEachBit(rays, [&](int i) HWY_ATTR { TraverseAlone(i, child); });
  }

  /// Traverses a child of any kind with one ray.
  HWY_NOINLINE void TraverseAlone(int i, std::uint32_t child) {
    const PacketRay ray(packet_, i);
    LeafVisitor<any, Tree, PacketRay> visitor(two_level_, tree_, Ray(i), ray, DistanceInWorld(i), std::nullopt,
                                              Nearest(i), counts_);
    visitor.limit = std::min(visitor.limit, packet_.limit[i]);
    TraverseFrom<any>(child, tree_, NodeRay(ray), visitor, counts_);
    packet_.limit[i] = visitor.limit;
    if constexpr (!any) visitor.HandOver([&](const auto&... candidate) HWY_ATTR { Keep(i, candidate...); });
    if (visitor.is_answered) Answer(i);
  }

  HWY_INLINE void VisitSphere(const SphereLeaf& leaf, std::uint32_t rays) {
    rays &= ~packet_.StartOrEndOn(leaf.primitive);
    if (std::popcount(rays) > few_rays) {
      const SphereMask mask =
          TestSphereLanes<any>(RoundedSphere(tree_.coordinates, leaf.sphere), packet_, limit_for_certain_);
      rays &= mask.maybe;
      ForEachBit(rays & mask.certain, [&](int i) { Answer(i); });
      rays &= ~mask.certain;
    }
    ForEachBit(rays, [&](int i) HWY_ATTR {
      if (!TestSphere<any>(leaf, Ray(i), Nearest(i), counts_)) return;
      if constexpr (any)
        Answer(i);
      else
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
    });
  }

  HWY_INLINE void VisitHulls(const HullBlock& block, std::uint32_t rays) {
    for (std::uint32_t k = 0; k < block.count; ++k) {
      const std::uint32_t maybe = TestHull(block, k) & rays;
      if (maybe != 0) VisitPrimitive(block.primitive[k], maybe);
    }
  }

  /// Returns the rays that do not certainly miss one hull of a block.
  HWY_INLINE std::uint32_t TestHull(const HullBlock& block, std::uint32_t k) const {
    const PacketFloats f;
    const HullLanes<PacketFloats> hull(block, [&](const float* numbers) { return hn::Set(f, numbers[k]); });
    std::uint32_t maybe = 0;
    for (std::size_t i = 0; i < packet_size; i += hn::Lanes(f)) {
      const auto load = [&](const FloatEach& each) { return hn::Load(f, each + i); };
      const HullRays<PacketFloats> rays{
          {load(packet_.origin[0]), load(packet_.origin[1]), load(packet_.origin[2])},
          {load(packet_.direction[0]), load(packet_.direction[1]), load(packet_.direction[2])},
          load(packet_.plane_error),
          load(packet_.limit)};
      hn::Vec<PacketFloats> entry;
      maybe |= Bits(f, TestHullLanes(f, hull, rays, entry)) << i;
    }
    return maybe;
  }

  HWY_INLINE void VisitPrimitive(std::uint32_t primitive, std::uint32_t rays) {
    const PrimRef what = tree_.primitives[primitive];
    if (what.element != PrimRef::whole)
      rays &= ~packet_.StartOrEndOn(two_level_.world->Instances()[what.instance].first_primitive + what.element);
    ForEachBit(rays, [&](int i) HWY_ATTR {
      if (TestPrimitive<any>(two_level_, tree_, primitive, Ray(i), DistanceInWorld(i), Nearest(i), counts_))
        Answer(i);
      else if constexpr (!any)
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
    });
  }

  void Answer(int i) {
    answered_ |= std::uint32_t{1} << i;
    packet_.limit[i] = -1;
  }

  /// The triangles of a block, prepared for broadcasting one at a time.
  struct TriangleArrays {
    alignas(32) float numbers[11][width];

    HWY_INLINE explicit TriangleArrays(const TriangleBlock& block) {
      const Lanes d;
      for (std::size_t k = 0; k < width; k += hn::Lanes(d)) {
        const TriangleLanes<Lanes> t = LoadTriangles(d, block, k);
        const Floats all[] = {t.edge1.x,  t.edge1.y,  t.edge1.z,  t.edge2.x, t.edge2.y, t.edge2.z,
                              t.normal.x, t.normal.y, t.normal.z, t.edges,   t.area};
        for (std::size_t n = 0; n < 11; ++n) hn::Store(all[n], d, numbers[n] + k);
      }
    }
    HWY_INLINE TriangleLanes<PacketFloats> Broadcast(int k) const {
      const auto set = [&](int n) { return hn::Set(PacketFloats(), numbers[n][k]); };
      return {{set(0), set(1), set(2)}, {set(3), set(4), set(5)}, {set(6), set(7), set(8)}, set(9), set(10)};
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

  /// Tests one triangle against those of `rays` that fill the lanes from number i on.
  HWY_INLINE void TestTriangle(const TriangleBlock& block, int k, const TriangleLanes<PacketFloats>& triangle,
                               std::size_t i, std::uint32_t rays) {
    const PacketFloats f;
    const auto load = [&](const FloatEach& each) { return hn::Load(f, each + i); };
    const float corner[] = {block.corner[0][k], block.corner[1][k], block.corner[2][k]};
    const Vec3<PacketFloats> to_corner = Broadcast(f, corner) - LoadEach(f, packet_.origin, i);
    const auto limit = load(packet_.limit);
    const RayLanes<PacketFloats> ray{LoadEach(f, packet_.direction, i), load(packet_.certain_from),
                                     load(packet_.edge_error), load(packet_.height_error), limit};
    TriangleMask<PacketFloats> mask;
    if (!TestLanes(f, triangle, to_corner, ray, mask)) return;
    const std::uint32_t maybe = Bits(f, mask.maybe) << i & rays;
    if constexpr (any) {
      const auto is_before = hn::Lt(mask.farthest, load(limit_for_certain_));
      const std::uint32_t certain = Bits(f, hn::And(mask.certain, is_before)) << i & maybe;
      ForEachBit(certain, [&](int j) { Answer(j); });
      if ((maybe & ~certain) != 0) TestEach(block, static_cast<std::uint32_t>(k), maybe & ~certain);
    } else {
      const auto least = hn::Min(limit, mask.farthest);
      hn::Store(hn::IfThenElse(mask.certain, least, limit), f, packet_.limit + i);
      hn::Store(mask.nearest, f, nearest_now_ + i);
      ForEachBit(maybe, [&](int j) HWY_ATTR { Keep(j, block, static_cast<std::uint32_t>(k), nearest_now_[j]); });
    }
  }

  /// Decides about one triangle for each of some rays. The rays that start on it are nearly always among them.
  HWY_INLINE void TestEach(const TriangleBlock& block, std::uint32_t lane, std::uint32_t rays) {
    const auto triangle = ExactTest::Locate(two_level_, tree_, std::nullopt, block, lane);
    ForEachBit(rays & ~packet_.StartOrEndOn(triangle.primitive), [&](int i) HWY_ATTR {
      if (ExactTestOf(i).Test(triangle)) Answer(i);
    });
  }

  HWY_INLINE void Keep(int i, const TriangleBlock& block, std::uint32_t lane, float nearest) {
    if (candidate_count_[i] == most_candidates) TestCandidates(i);
    candidates_[i][candidate_count_[i]++] = {&block, lane, nearest};
  }

  HWY_INLINE void TestCandidates(int i) {
    auto exact_test = ExactTestOf(i);
    while (candidate_count_[i] > 0) {
      const Candidate& candidate = candidates_[i][--candidate_count_[i]];
      if (candidate.nearest <= packet_.limit[i] &&
          exact_test.Test(exact_test.Locate(*candidate.block, candidate.lane)) && candidate_count_[i] > 0)
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
    }
  }

  /// Decides about all candidates: first about one per ray, which nearly always is all of them, together.
  HWY_INLINE void TestAllCandidates() {
    if constexpr (any) return;
    if constexpr (ExactTriangleLanes::is_compiled) TestLastCandidates();
    for (int i = 0; i < Size(); ++i)
      if (candidate_count_[i] > 0) TestCandidates(i);
  }

  HWY_INLINE void TestLastCandidates() {
    struct Test {
      int ray;
      typename ExactTest::TriangleRef triangle;
    };
    Test tests[packet_size];
    int count = 0;
    for (int i = 0; i < Size(); ++i) {
      while (candidate_count_[i] > 0) {
        const Candidate& candidate = candidates_[i][--candidate_count_[i]];
        if (candidate.nearest > packet_.limit[i]) continue;
        const auto triangle = ExactTest::Locate(two_level_, tree_, std::nullopt, *candidate.block, candidate.lane);
        if (triangle.IsAtAnEndOf(Ray(i))) continue;
        if (tree_.is_large) triangle.PrefetchCorners();
        tests[count++] = {i, triangle};
        break;
      }
    }
    ExactTriangleLanes lanes;
    for (int k = 0; k < count; ++k)
      lanes.Add(Ray(tests[k].ray), Nearest(tests[k].ray).TMaxOf(Ray(tests[k].ray)), tests[k].triangle.Corners());
    const ExactMask mask = lanes.Test();
    counts_.primitive_tests += static_cast<std::uint64_t>(std::popcount(~mask.unsure & ((1U << count) - 1)));
    ForEachBit(mask.hit, [&](int k) HWY_ATTR {
      const int i = tests[k].ray;
      Nearest(i).TakeIfAhead({lanes.HitOf(k), tests[k].triangle.instance, tests[k].triangle.element});
      if (candidate_count_[i] > 0)
        packet_.limit[i] = std::min(packet_.limit[i], packet_.Distance(i, Nearest(i).Limit()));
    });
    ForEachBit(mask.unsure, [&](int k) HWY_ATTR { ExactTestOf(tests[k].ray).Test(tests[k].triangle); });
  }

  const TwoLevel<Tree>& two_level_;
  const Tree& tree_;
  std::span<const R3::Ray> rays_;
  std::optional<WorldHit>* hits_;
  Counts& counts_;
  std::uint32_t answered_ = 0;  // the rays of `any` that have hit something, as bits
  Packet packet_;
  alignas(64) FloatEach limit_for_certain_, nearest_now_;
  std::uint8_t candidate_count_[packet_size] = {};
  Candidate candidates_[packet_size][most_candidates];
  static_assert(std::is_trivially_destructible_v<NearestHit>);
  alignas(NearestHit) std::byte nearest_[(any ? 1 : packet_size) * sizeof(NearestHit)];
};

/// Computes FindNearest or FindAny for each of the rays, with the same results, since the exact test decides in the
/// end. Counts the hits of `any`.
template <bool any>
void TracePackets(const TwoLevel<Tree>& two_level, std::span<const R3::Ray> rays,
                  std::conditional_t<any, bool, std::optional<WorldHit>>* answers, Counts& counts) {
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const auto packet = rays.subspan(first, std::min<std::size_t>(rays.size() - first, packet_size));
    if constexpr (any) {
      std::optional<WorldHit> none;
      PacketTraversal<true> traversal(two_level, packet, &none, counts);
      traversal.Search();
      counts.hits += static_cast<std::uint64_t>(std::popcount(traversal.Answered()));
      std::fill_n(answers + first, packet.size(), false);
      ForEachBit(traversal.Answered(), [&](int i) { answers[first + static_cast<std::size_t>(i)] = true; });
    } else {
      PacketTraversal<false>(two_level, packet, answers + first, counts).Search();
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
