// Tests of the leaves that a traversal visits, decisions about candidates in double precision, and the search of a
// whole structure. Included once per instruction set.

#if defined(RAY_ACCELERATE_WIDE_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#undef RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#else
#define RAY_ACCELERATE_WIDE_SEARCH_INL_H_
#endif

#include <bit>
#include <limits>
#include <optional>

#include "R3/Mesh.h"
#include "R3/Sphere.h"
#include "R3/Triangle.h"
#include "source/accelerate/NearestHit.h"
#include "source/accelerate/wide/Hulls-inl.h"
#include "source/accelerate/wide/Triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

template <bool any, typename Structure>
bool Search(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
            double distance_in_world, std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts);

/// The watertight ray/triangle test in double precision, for one ray and the triangles of one structure.
template <bool any, typename Structure>
class ExactTriangleTest {
 public:
  struct TriangleRef {
    const R3::Point* positions;  // of the mesh
    std::array<std::uint32_t, 3> corners;
    std::uint32_t instance;
    std::int32_t element;
    std::int64_t primitive;  // in the world's numbering

    /// Returns true if the ray starts or ends on it, and therefore does not meet it.
    bool IsAtAnEndOf(const R3::Ray& of) const { return primitive == of.leaving || primitive == of.reaching; }
    std::array<const R3::Point*, 3> Corners() const {
      return {positions + corners[0], positions + corners[1], positions + corners[2]};
    }
    // Always inlined: g++ removes calls of functions that only prefetch, because they have no effect.
    HWY_INLINE void PrefetchCorners() const {
      for (const std::uint32_t corner : corners) __builtin_prefetch(positions + corner);
    }
  };

  HWY_INLINE ExactTriangleTest(const TwoLevel<Structure>& the_two_level, const Structure& the_structure,
                               const R3::Ray& the_ray, std::optional<std::uint32_t> instance, NearestHit& the_nearest,
                               Counts& the_counts)
      : two_level(the_two_level),
        structure(the_structure),
        ray(the_ray),
        nearest(the_nearest),
        counts(the_counts),
        instance_(instance) {}

  // The structure searched, and the ray.
  const TwoLevel<Structure>& two_level;
  const Structure& structure;
  const R3::Ray& ray;
  NearestHit& nearest;
  Counts& counts;

  HWY_INLINE TriangleRef Locate(const TriangleBlock& block, std::uint32_t lane) const {
    return Locate(two_level, structure, instance_, block, lane);
  }
  static HWY_INLINE TriangleRef Locate(const TwoLevel<Structure>& two_level, const Structure& structure,
                                       std::optional<std::uint32_t> instance_of_mesh, const TriangleBlock& block,
                                       std::uint32_t lane) {
    const PrimRef what = structure.primitives[block.primitive[lane]];
    const std::uint32_t of = instance_of_mesh.value_or(what.instance);
    const Instance& instance = two_level.world->Instances()[of];
    return {instance.mesh->Data().positions.data(),
            {block.positions[0][lane], block.positions[1][lane], block.positions[2][lane]},
            of,
            what.element,
            instance.first_primitive + what.element};
  }

  /// Tests a triangle; returns true if there is a relevant hit, which with `any` ends the search.
  HWY_FLATTEN bool Test(const TriangleRef& triangle) {
    if (triangle.IsAtAnEndOf(ray)) return false;
    if (!sheared_) sheared_.emplace(ray);  // most rays need none
    if constexpr (!any) sheared_->t_max = nearest.TMaxOf(ray);
    ++counts.primitive_tests;
    const auto hit = R3::IntersectTriangleInline(*sheared_, triangle.Corners());
    if (!hit) return false;
    const WorldHit found{*hit, triangle.instance, triangle.element};
    if constexpr (any) return nearest.IsInTheWay(found);
    nearest.TakeIfAhead(found);
    return true;
  }

 private:
  std::optional<std::uint32_t> instance_;
  std::optional<R3::ShearedRay> sheared_;
};

/// Tests an element by its shape; returns true if there is a relevant hit, which with `any` ends the search.
template <bool any>
bool TestElement(std::uint32_t instance, int element, const R3::Ray& local, NearestHit& nearest, Counts& counts) {
  if constexpr (any) return nearest.IsInTheWay(instance, element, local, counts);
  nearest.Test(instance, element, local, counts);
  return true;
}

/// Tests a sphere, compiled for the instruction set.
template <bool any>
HWY_NOINLINE HWY_FLATTEN bool TestSphere(const SphereLeaf& leaf, const R3::Ray& ray, NearestHit& nearest,
                                         Counts& counts) {
  double begin = ray.t_min;
  if (leaf.primitive == ray.leaving || leaf.primitive == ray.reaching) {
    if (leaf.primitive == ray.reaching || ray.leaving_until == R3::infinity) return false;
    begin = ray.leaving_until;
  }
  const auto hit = R3::IntersectSphereInline(ray, leaf.sphere, begin, nearest.TMaxOf(ray));
  if (hit && IsNearStart(ray, hit->t)) [[unlikely]]
    return TestElement<any>(leaf.instance, 0, ray, nearest, counts);
  ++counts.primitive_tests;
  if (!hit) return false;
  const WorldHit found{*hit, leaf.instance, 0};
  if constexpr (any) return nearest.IsInTheWay(found);
  nearest.Offer(found);
  return true;
}

/// Tests a primitive that is neither a triangle nor a sphere in the structure's frame: any other shape, or a whole
/// shared mesh. Returns true if there is a hit and `any` is set.
template <bool any, typename Structure>
bool TestPrimitive(const TwoLevel<Structure>& two_level, const Structure& structure, std::uint32_t primitive,
                   const R3::Ray& ray, double distance_in_world, NearestHit& nearest, Counts& counts) {
  const PrimRef what = structure.primitives[primitive];
  const Instance& instance = two_level.world->Instances()[what.instance];
  if (what.element != PrimRef::whole && instance.BeginOf(ray, what.element) == R3::infinity) return false;
  const auto test = [&](const R3::Ray& local) {
    if (what.element == PrimRef::whole)
      return Search<any>(two_level, two_level.structures[static_cast<std::size_t>(instance.shared) + 1], local,
                         distance_in_world, what.instance, nearest, counts);
    return TestElement<any>(what.instance, what.element, local, nearest, counts) && any;
  };
  return instance.frame == 0 ? test(ray) : test(two_level.world->Back(instance.frame, ray));
}

/// A visitor that tests the leaves of a traversal. With `any`, for occlusion rays, the first hit ends the search.
/// Otherwise triangles that may need the exact test remain candidates until the end; the addresses of their corners are
/// looked up in steps during the traversal, so that the exact test need not wait for them.
template <bool any, typename Structure, typename RayInBoxes = TraversalRay>
class LeafVisitor {
 public:
  HWY_INLINE LeafVisitor(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
                         const RayInBoxes& traversal_ray, double distance_in_world,
                         std::optional<std::uint32_t> instance, NearestHit& nearest, Counts& counts)
      : limit(traversal_ray.Distance(nearest.Limit())),
        traversal_ray_(traversal_ray),
        distance_in_world_(distance_in_world),
        limit_for_certain_(any ? traversal_ray.Distance(end_of_certainty * ray.t_max) - 4 * traversal_ray.plane_error
                               : 0),
        exact_test_(two_level, structure, ray, instance, nearest, counts) {}

  float limit;               // hits farther along the traversal ray are irrelevant
  bool is_answered = false;  // with `any`: there is a hit

  /// Visits a block of triangles; returns true if that ends the search.
  HWY_INLINE bool VisitTriangles(const TriangleBlock& block) {
    BlockMask mask;
    TestTriangles(block, traversal_ray_, limit, mask);
    for (std::uint32_t rest = mask.maybe; rest; rest &= rest - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
      const bool is_certain = mask.certain >> i & 1;
      if constexpr (any) {
        is_answered =
            (is_certain && mask.farthest[i] < limit_for_certain_) || exact_test_.Test(exact_test_.Locate(block, i));
        if (is_answered) return true;
      } else {
        constexpr float none = std::numeric_limits<float>::infinity();
        Keep(block, i, mask.nearest[i], is_certain ? mask.farthest[i] : none);
      }
    }
    return false;
  }

  /// Visits a leaf of one sphere; returns true if that ends the search.
  HWY_INLINE bool VisitSphere(const SphereLeaf& leaf) {
    if (!TestSphere<any>(leaf, exact_test_.ray, exact_test_.nearest, exact_test_.counts)) return false;
    if constexpr (any) return is_answered = true;
    limit = std::min(limit, traversal_ray_.Distance(exact_test_.nearest.Limit()));
    return false;
  }

  /// Visits a primitive that is neither triangle nor sphere; returns true if that ends the search.
  bool VisitPrimitive(std::uint32_t primitive) {
    if constexpr (!any) TestCandidatesNow();
    is_answered = TestPrimitive<any>(exact_test_.two_level, exact_test_.structure, primitive, exact_test_.ray,
                                     distance_in_world_, exact_test_.nearest, exact_test_.counts);
    if constexpr (any) return is_answered;
    limit = std::min(limit, traversal_ray_.Distance(exact_test_.nearest.Limit()));
    return false;
  }

  /// Visits primitives by their hulls, the nearest first; returns true if that ends the search.
  bool VisitHulls(const HullBlock& block) {
    alignas(32) float entries[width];
    std::uint32_t rest = TestHulls(block, traversal_ray_, limit, entries);
    while (rest != 0) {
      const int i = any ? std::countr_zero(rest) : NearestOf(rest, entries);
      rest &= ~(std::uint32_t{1} << i);
      if (entries[i] > limit) return false;
      if (VisitPrimitive(block.primitive[i])) return true;
    }
    return false;
  }

  /// Passes the candidates that may still be the nearest to `keep`, which decides about them.
  template <typename Keeper>
  HWY_INLINE void HandOver(const Keeper& keep) {
    for (int i = 0; i < count_; ++i)
      if (candidates_[i].nearest <= limit) keep(*candidates_[i].block, candidates_[i].lane, candidates_[i].nearest);
    count_ = 0;
  }

  /// Decides about the candidates that may still be the nearest, last found first.
  HWY_INLINE void TestCandidates() {
    while (count_ > 0) {
      --count_;
      if (candidates_[count_].nearest <= limit && exact_test_.Test(candidates_[count_].triangle))
        limit = std::min(limit, traversal_ray_.Distance(exact_test_.nearest.Limit()));
    }
  }

 private:
  static int NearestOf(std::uint32_t some, const float* entries) {
    int nearest = std::countr_zero(some);
    for (some &= some - 1; some != 0; some &= some - 1)
      if (entries[std::countr_zero(some)] < entries[nearest]) nearest = std::countr_zero(some);
    return nearest;
  }

  struct Candidate {
    const TriangleBlock* block;
    std::uint32_t lane;
    float nearest;
    typename ExactTriangleTest<any, Structure>::TriangleRef triangle;
  };
  static constexpr int most_candidates = 16;

  /// A version out of line for rare calls, since the kernels are compiled many times.
  HWY_NOINLINE void TestCandidatesNow() { TestCandidates(); }

  HWY_INLINE void Keep(const TriangleBlock& block, std::uint32_t lane, float nearest, float farthest) {
    const auto triangle = exact_test_.Locate(block, lane);
    if constexpr (Structure::meets_primitives_again)
      if (count_ > 0 && candidates_[count_ - 1].triangle.primitive == triangle.primitive) return;
    if (count_ == most_candidates) TestCandidatesNow();
    if (triangle.primitive == exact_test_.ray.leaving) return;
    triangle.PrefetchCorners();
    candidates_[count_++] = {&block, lane, nearest, triangle};
    limit = std::min(limit, farthest);
  }

  const RayInBoxes& traversal_ray_;
  double distance_in_world_;
  float limit_for_certain_;  // up to which certain hits of a shadow ray block it
  ExactTriangleTest<any, Structure> exact_test_;
  int count_ = 0;
  Candidate candidates_[most_candidates];
};

/// Searches one structure; `instance` is that of the shared mesh inside of which it is. Returns true if `any` is set
/// and there is a hit. Each structure has its own Traverse, which visits leaves until Visit... returns true or nothing
/// is left before the limit.
template <bool any, typename Structure>
HWY_INLINE bool SearchInline(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
                             double distance_in_world, std::optional<std::uint32_t> instance, NearestHit& nearest,
                             Counts& counts) {
  const TraversalRay traversal_ray(structure.coordinates, structure.primitives.PaddingPerDistance(), ray,
                                   distance_in_world);
  if (traversal_ray.is_lost) return false;
  LeafVisitor<any, Structure> visitor(two_level, structure, ray, traversal_ray, distance_in_world, instance, nearest,
                                      counts);
  Traverse<any>(structure, traversal_ray, visitor, counts);
  if constexpr (!any) visitor.TestCandidates();
  return visitor.is_answered;
}

/// SearchInline, out of line: for the insides of shared meshes.
template <bool any, typename Structure>
HWY_NOINLINE bool Search(const TwoLevel<Structure>& two_level, const Structure& structure, const R3::Ray& ray,
                         double distance_in_world, std::optional<std::uint32_t> instance, NearestHit& nearest,
                         Counts& counts) {
  return SearchInline<any>(two_level, structure, ray, distance_in_world, instance, nearest, counts);
}

template <typename Structure>
void FindNearest(const TwoLevel<Structure>& two_level, const R3::Ray& ray, NearestHit& nearest, Counts& counts) {
  SearchInline<false>(two_level, two_level.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt,
                      nearest, counts);
}

template <typename Structure>
bool FindAny(const TwoLevel<Structure>& two_level, const R3::Ray& ray, Counts& counts) {
  std::optional<WorldHit> best;
  NearestHit nearest(*two_level.world, ray, best);
  return SearchInline<true>(two_level, two_level.structures[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))),
                            std::nullopt, nearest, counts);
}

template <typename Structure>
Kernels<Structure> CompiledKernels() {
  return {HWY_TARGET, &FindNearest<Structure>, &FindAny<Structure>, nullptr, nullptr};
}

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#endif
