#include "source/accelerate/bvh/Kernels.h"

#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>

#include "R3/Mesh.h"
#include "R3/Triangle.h"
#include "source/accelerate/bvh/Build.h"

// Highway compiles the rest of this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/bvh/Kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Where single precision may err, it errs on the side of asking. All coordinates are the tree's, so at most 1 in boxes
// and triangles; u is 2^-24. With r = 1 + the largest coordinate of the ray's origin:
//   - A plane rounded to float is off by u/2, the origin by u r, their product with 1/d by u r, 1/d itself (with d
//     rounded before) by 2 u of the distance, at most 2 u r, the difference by u r: together less than 8 u r in terms of
//     where the plane is. So each ray moves all planes outward by 8 u r: that is its slack.
//   - With c = corner - origin (off by 2 u r), edges off by u each, R = c x d is off by 8 u r, R . e by 12 u r |e| with
//     |e| the sum of magnitudes, the normal times d by 12 u |e1| |e2| <= 72 u |e1|; all three edge functions together by
//     less than 32 u (r + 6) (|e1| + |e2|).
//   - What doubles lose is 2^-50 of the origin's distance before it was moved near; 2^-20 u of it is in r.
HWY_BEFORE_NAMESPACE();
namespace ray::bvh {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, width>;
using Floats = hn::Vec<Lanes>;

inline constexpr float u = 0x1p-24f;

/// A ray in a tree's coordinates, begun where it enters the tree's box.
struct Probe {
  float origin[3], direction[3], inverse[3];
  float near_shift[3], far_shift[3];  // (origin +- slack) * inverse
  int near_plane[3];                  // index into Node::plane; the far one is its other neighbour
  float slack_of_edges;               // times (|e1| + |e2|)
  float slack;
  double per_t, begin;                // distance along the probe = t * per_t - begin
  bool is_lost = false;               // it misses the tree's box

  float Distance(double t) const {
    return static_cast<float>(t * per_t - begin) * (1 + 4 * u) + slack;
  }

  Probe(const Tree& tree, const R3::Ray& ray, double distance_in_world) {
    const R3::Vector from = tree.scale * (ray.origin - tree.center);
    const double longest = MaxComponent(Abs(ray.direction));
    const R3::Vector along = ray.direction / longest;
    per_t = longest * tree.scale;

    // Enter the box, generously, so that the coordinates are no larger than they need be.
    const double far = MaxComponent(Abs(from));
    const double more = tree.space.PadPerDistance() * distance_in_world * tree.scale;
    begin = ray.t_min * per_t;
    if (far > 2 + more) {
      const double reach = 1 + 0x1p-10 + 0x1p-40 * far + more;
      double enter = begin, leave = ray.t_max * per_t;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = (-reach - from[axis]) / along[axis], b = (reach - from[axis]) / along[axis];
        enter = std::max(enter, std::min(a, b));  // a NaN, from a ray in the plane, leaves things as they were
        leave = std::min(leave, std::max(a, b));
      }
      if (enter > leave * (1 + 0x1p-40) + 0x1p-40 * far) {
        is_lost = true;
        return;
      }
      begin = enter;
    }
    if (!(std::abs(begin) < 0x1p1000)) begin = 0;
    const R3::Vector start = from + begin * along;
    const double origin_reach = 1 + MaxComponent(Abs(start)) + 0x1p-20 * (far + std::abs(begin)) + more / (8 * u);
    const float r = static_cast<float>(origin_reach);
    const bool is_measurable = origin_reach < 0x1p60;  // otherwise everything is asked
    slack = is_measurable ? 8 * u * r : std::numeric_limits<float>::infinity();
    slack_of_edges = is_measurable ? 32 * u * (r + 6) : std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      constexpr float flat = 0x1p-40f;  // moves the ray by less than the slack, and keeps all products finite
      const float d = static_cast<float>(along[axis]);
      const float steep = std::abs(d) < flat ? std::copysign(flat, d) : d;
      origin[axis] = is_measurable ? static_cast<float>(start[axis]) : 0;
      direction[axis] = d;
      inverse[axis] = is_measurable ? 1 / steep : 0;
      const bool is_backward = std::signbit(d);
      near_plane[axis] = 2 * axis + (is_backward ? 1 : 0);
      const float outward = is_backward ? -slack : slack;
      near_shift[axis] = is_measurable ? (origin[axis] + outward) * inverse[axis] : slack;
      far_shift[axis] = is_measurable ? (origin[axis] - outward) * inverse[axis] : -slack;
    }
  }
};

/// Which children of a node the probe enters before `limit`, as bits; and where.
HWY_INLINE std::uint32_t TestBoxes(const Node& node, const Probe& probe, float limit, float* HWY_RESTRICT entries) {
  const Lanes lanes;
  std::uint32_t reached = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
    const auto enter = [&](int axis) {
      return hn::MulSub(hn::Load(lanes, node.plane[probe.near_plane[axis]] + i), hn::Set(lanes, probe.inverse[axis]),
                        hn::Set(lanes, probe.near_shift[axis]));
    };
    const auto leave = [&](int axis) {
      return hn::MulSub(hn::Load(lanes, node.plane[probe.near_plane[axis] ^ 1] + i),
                        hn::Set(lanes, probe.inverse[axis]), hn::Set(lanes, probe.far_shift[axis]));
    };
    const Floats entry = hn::Max(hn::Max(enter(0), enter(1)), hn::Max(enter(2), hn::Zero(lanes)));
    const Floats exit = hn::Min(hn::Min(leave(0), leave(1)), hn::Min(leave(2), hn::Set(lanes, limit)));
    hn::Store(entry, lanes, entries + i);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(lanes, hn::Le(entry, exit), bits);
    reached |= static_cast<std::uint32_t>(bits[0]) << i;
  }
  return reached;
}

/// Which triangles of a block are not certainly missed before `limit`, as bits.
///   source  the edge functions of Moller, Trumbore, Fast, minimum storage ray/triangle intersection (1997), undivided
HWY_INLINE std::uint32_t TestTriangles(const TriangleBlock& block, const Probe& probe, float limit) {
  const Lanes lanes;
  std::uint32_t possible = 0;
  for (std::size_t i = 0; i < width; i += hn::Lanes(lanes)) {
    const auto set = [&](float x) { return hn::Set(lanes, x); };
    const auto load = [&](const float* from) { return hn::Load(lanes, from + i); };
    const Floats dx = set(probe.direction[0]), dy = set(probe.direction[1]), dz = set(probe.direction[2]);
    const Floats cx = hn::Sub(load(block.corner[0]), set(probe.origin[0]));
    const Floats cy = hn::Sub(load(block.corner[1]), set(probe.origin[1]));
    const Floats cz = hn::Sub(load(block.corner[2]), set(probe.origin[2]));
    const Floats ax = load(block.edge1[0]), ay = load(block.edge1[1]), az = load(block.edge1[2]);
    const Floats bx = load(block.edge2[0]), by = load(block.edge2[1]), bz = load(block.edge2[2]);
    const auto minus = [](Floats p, Floats q, Floats r, Floats s) { return hn::MulSub(p, q, hn::Mul(r, s)); };
    const auto dot = [](Floats px, Floats py, Floats pz, Floats qx, Floats qy, Floats qz) {
      return hn::MulAdd(px, qx, hn::MulAdd(py, qy, hn::Mul(pz, qz)));
    };
    const Floats rx = minus(cy, dz, cz, dy), ry = minus(cz, dx, cx, dz), rz = minus(cx, dy, cy, dx);
    const Floats nx = minus(ay, bz, az, by), ny = minus(az, bx, ax, bz), nz = minus(ax, by, ay, bx);
    const Floats facing = dot(nx, ny, nz, dx, dy, dz);
    const Floats v = dot(rx, ry, rz, bx, by, bz);
    const Floats w = hn::Neg(dot(rx, ry, rz, ax, ay, az));
    const Floats rest = hn::Sub(hn::Sub(facing, v), w);
    const Floats edges = hn::Add(hn::Add(hn::Add(hn::Abs(ax), hn::Abs(ay)), hn::Add(hn::Abs(az), hn::Abs(bx))),
                                 hn::Add(hn::Abs(by), hn::Abs(bz)));
    // The last term is for products below the range of floats.
    const Floats slack = hn::MulAdd(edges, set(probe.slack_of_edges), set(1e-30f));
    const Floats least = hn::Min(v, hn::Min(w, rest)), most = hn::Max(v, hn::Max(w, rest));
    auto maybe = hn::Or(hn::Ge(least, hn::Neg(slack)), hn::Le(most, slack));
    if (!hn::AllFalse(lanes, maybe)) {
      // Beyond the limit or behind the start for certain; edge-on, nothing is certain.
      const Floats height = dot(nx, ny, nz, cx, cy, cz), steep = hn::Abs(facing);
      const Floats ahead = hn::Xor(height, hn::And(facing, hn::SignBit(lanes)));
      const Floats slack_of_height = hn::MulAdd(slack, set(4), slack);
      const auto is_clear = hn::Gt(steep, slack);
      const auto is_far = hn::Gt(hn::Sub(ahead, slack_of_height), hn::Mul(set(limit), hn::Add(steep, slack)));
      const auto is_behind = hn::Lt(hn::Add(ahead, slack_of_height), hn::Zero(lanes));
      maybe = hn::AndNot(hn::And(is_clear, hn::Or(is_far, is_behind)), maybe);
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(lanes, maybe, bits);
    possible |= static_cast<std::uint32_t>(bits[0]) << i;
  }
  return possible;
}

/// One walk through one tree. `instance` is the shared mesh's whose inside this is.
template <bool any>
class Walk {
 public:
  Walk(const Forest& forest, NearestHit& nearest, Counts& counts) : forest_(forest), nearest_(nearest), counts_(counts) {}

  void Through(const Tree& tree, const R3::Ray& ray, double distance_in_world, std::optional<std::uint32_t> instance) {
    const Probe probe(tree, ray, distance_in_world);
    if (probe.is_lost) return;
    struct Waiting {
      float entry;
      std::uint32_t child;
    };
    Waiting stack[most_depth * width];
    int waiting = 0;
    std::uint32_t child = tree.root;
    float limit = probe.Distance(nearest_.Limit());
    std::optional<R3::ShearedRay> sheared;
    std::uint64_t visits = 0, primitives = 0;

    while (true) {
      switch (Child::KindOf(child)) {
        case Child::Kind::node: {
          ++visits;
          const Node& node = tree.nodes[Child::Index(child)];
          alignas(32) float entries[width];
          std::uint32_t reached = TestBoxes(node, probe, limit, entries);
          if (reached == 0) break;
          int first = std::countr_zero(reached);
          reached &= reached - 1;
          if (reached == 0) {
            child = node.child[first];
            continue;
          }
          // The nearest goes on, the others wait, the farthest lowest.
          if constexpr (any) {
            for (; reached; reached &= reached - 1) {
              const int other = std::countr_zero(reached);
              stack[waiting++] = {entries[other], node.child[other]};
            }
          } else {
            const int base = waiting;
            for (; reached; reached &= reached - 1) {
              int other = std::countr_zero(reached);
              if (entries[other] < entries[first]) std::swap(first, other);
              int at = waiting++;
              while (at > base && stack[at - 1].entry < entries[other]) stack[at] = stack[at - 1], --at;
              stack[at] = {entries[other], node.child[other]};
            }
          }
          if (tree.is_large)
            for (int i = waiting; i-- > std::max(waiting - 2, 0);) Fetch(tree, stack[i].child);
          child = node.child[first];
          continue;
        }
        case Child::Kind::triangles: {
          ++visits;
          const TriangleBlock& block = tree.blocks[Child::Index(child)];
          for (std::uint32_t possible = TestTriangles(block, probe, limit); possible; possible &= possible - 1) {
            if (!sheared) sheared.emplace(ray);
            ++primitives;
            if (AskTriangle(tree, block.item[std::countr_zero(possible)], *sheared, instance)) {
              if constexpr (any) goto done;
              limit = probe.Distance(nearest_.Limit());
            }
          }
          break;
        }
        case Child::Kind::item: {
          ++visits;
          AskItem(tree, Child::Index(child), ray, distance_in_world);
          if constexpr (any) {
            if (nearest_.Best()) goto done;
          }
          limit = probe.Distance(nearest_.Limit());
          break;
        }
        case Child::Kind::nothing:
          break;
      }
      do {
        if (waiting == 0) goto done;
        --waiting;
      } while (stack[waiting].entry > limit);
      child = stack[waiting].child;
    }
  done:
    counts_.node_visits += visits;
    counts_.box_tests += visits;
    counts_.primitive_tests += primitives;
  }

 private:
  static void Fetch(const Tree& tree, std::uint32_t child) {
    const char* at = Child::KindOf(child) == Child::Kind::node
                         ? reinterpret_cast<const char*>(tree.nodes.Data() + Child::Index(child))
                         : reinterpret_cast<const char*>(tree.blocks.Data() + Child::Index(child));
    for (int line = 0; line < 4; ++line) __builtin_prefetch(at + 64 * line);
  }

  bool AskTriangle(const Tree& tree, std::uint32_t item, R3::ShearedRay& sheared,
                   std::optional<std::uint32_t> instance) {
    const Item what = tree.space[item];
    const std::uint32_t of = instance.value_or(what.instance);
    const R3::Mesh& mesh = *forest_.world->Instances()[of].mesh;
    if (nearest_.Best()) sheared.t_max = std::min(sheared.t_max, R3::NextUp(nearest_.Limit()));
    const auto hit = IntersectTriangle(sheared, mesh.Corners(what.element));
    if (!hit) return false;
    nearest_.Offer({*hit, of, what.element});
    return true;
  }

  void AskItem(const Tree& tree, std::uint32_t item, const R3::Ray& ray, double distance_in_world) {
    const Item what = tree.space[item];
    const Instance& instance = forest_.world->Instances()[what.instance];
    const R3::Transform& frame = forest_.world->Frames()[instance.frame];
    const R3::Ray local = instance.frame == 0 ? ray : frame.Back(ray);
    if (what.element == Item::whole)
      Through(forest_.trees[static_cast<std::size_t>(instance.shared) + 1], local, distance_in_world, what.instance);
    else
      nearest_.Test(what.instance, what.element, local, counts_);
  }

  const Forest& forest_;
  NearestHit& nearest_;
  Counts& counts_;
};

template <bool any>
void Find(const Forest& forest, const R3::Ray& ray, NearestHit& nearest, Counts& counts) {
  Walk<any>(forest, nearest, counts)
      .Through(forest.trees[0], ray, MaxComponent(Abs(FromOrigin(ray.origin))), std::nullopt);
}

Kernels Compiled() { return {hwy::TargetName(HWY_TARGET), &Find<false>, &Find<true>}; }

}  // namespace HWY_NAMESPACE
}  // namespace ray::bvh
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray::bvh {
namespace {

HWY_EXPORT(Compiled);

/// One entry for each instruction set of this machine, the best first.
const std::vector<Kernels>& AllKernels() {
  static const std::vector<Kernels> all = [] {
    std::vector<Kernels> list;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      list.push_back(HWY_DYNAMIC_DISPATCH(Compiled)());
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return list;
  }();
  return all;
}

}  // namespace

std::vector<std::string> InstructionSets() {
  std::vector<std::string> names;
  for (const Kernels& kernels : AllKernels()) names.emplace_back(kernels.name);
  return names;
}

const Kernels& ChooseKernels(const std::string& instruction_set) {
  for (const Kernels& kernels : AllKernels())
    if (instruction_set == "best" || instruction_set == kernels.name) return kernels;
  throw std::invalid_argument("this machine has no instruction set " + instruction_set);
}

std::size_t Forest::Bytes() const {
  std::size_t sum = 0;
  for (const Tree& tree : trees) sum += tree.Bytes();
  return sum;
}

}  // namespace ray::bvh
#endif
