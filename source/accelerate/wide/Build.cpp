#include "source/accelerate/wide/Build.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <memory>

#include "source/accelerate/wide/Layout.h"

namespace ray::wide {
namespace {

/// A primitive's box while the tree is being built. The fourth floats contain the primitive's number and kind, as
/// floats of usual size so that operations on all four lanes cost no more.
struct Reference {
  Float4 low, high;

  Extent Box() const { return {low, high}; }
  Float4 Middle() const { return low + high; }  // twice the center
  static constexpr std::uint32_t usual = 0x40000000;
  std::uint32_t Primitive() const { return std::bit_cast<std::uint32_t>(static_cast<float>(low[3])) ^ usual; }
  Child::Kind Kind() const { return static_cast<Child::Kind>(static_cast<std::uint32_t>(high[3])); }
  bool IsOf(Child::Kind kind) const { return static_cast<float>(high[3]) == AsFloat(kind); }
  static constexpr float AsFloat(Child::Kind kind) { return static_cast<float>(static_cast<std::uint32_t>(kind)); }
};

/// A contiguous range of references that form a subtree.
struct Range {
  std::uint32_t begin = 0, end = 0, triangles = 0, hulls = 0;
  Extent box, middles;

  std::uint32_t Size() const { return end - begin; }
  /// Returns true unless all are triangles, all hulls, or all others.
  bool IsMixed() const { return std::max({triangles, hulls, Size() - triangles - hulls}) < Size(); }
  /// Extends the range by a reference that it contains or will contain.
  void Extend(const Reference& r) {
    box.Extend(r.Box());
    middles.Extend(r.Middle());
    triangles += r.IsOf(Child::Kind::triangles) ? 1 : 0;
    hulls += r.IsOf(Child::Kind::hulls) ? 1 : 0;
  }
};

constexpr int most_bins = 32;

/// The references between two planes.
struct Bin {
  Extent box;
  std::uint64_t counts = 0;  // of triangles, and in the high half of others

  void Add(const Reference& reference) {
    box.Extend(reference.Box());
    counts += reference.IsOf(Child::Kind::triangles) ? 1 : std::uint64_t{1} << 32;
  }
  void Add(const Bin& o) { box.Extend(o.box), counts += o.counts; }
  std::uint32_t Triangles() const { return static_cast<std::uint32_t>(counts); }
  std::uint32_t Others() const { return static_cast<std::uint32_t>(counts >> 32); }
};

/// The bins of a range. Only bins in use are initialized: most ranges are small and have few.
struct Bins {
  int count;
  union {
    Bin of[3][most_bins];
  };

  explicit Bins(int bins) : count(bins) {
    for (auto& axis : of) std::uninitialized_fill_n(axis, count, Bin());
  }
  void Add(const Bins& o) {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < count; ++i) of[axis][i].Add(o.of[axis][i]);
  }
};

/// The bin of a center, identical for every instruction set: one subtraction, one product.
struct Binning {
  Float4 low, scale;
  int count;

  Binning(const Extent& middles, int bins) : low(middles.low), count(bins) {
    const Float4 size = middles.high - middles.low;
    for (int axis = 0; axis < 4; ++axis) {
      const float per_bin = static_cast<float>(bins) * (1 - 0x1p-20f) / size[axis];
      scale[axis] = size[axis] > 0 && per_bin < infinity ? per_bin : 0;
    }
  }
  bool IsFlat(int axis) const { return scale[axis] == 0; }
  Whole4 operator()(Float4 middle) const {
    return __builtin_convertvector(Least((middle - low) * scale, Float4{} + static_cast<float>(count - 1)), Whole4);
  }
};

struct Split {
  float cost = infinity;  // area times tests, of both sides
  int axis = -1, bin = 0;
};

class Builder {
 public:
  Builder(Tree& tree, int leaf_size) : tree_(tree), leaf_(static_cast<std::uint32_t>(leaf_size)) {}

  void Run() {
    const std::uint32_t count = tree_.primitives.Size();
    if (count == 0) return;
    tree_.coordinates = FitCoordinates(tree_.primitives);
    Range all = Collect();
    BuildChild root = IsLeaf(all) ? Leaf(all) : BuildChild{.box = all.box, .below = BuildNodeOf(all, 1)};
    tree_.root = Flatten({&root, 1}, tree_)[0];
  }

 private:
  static constexpr std::uint32_t parallel_from = 4096;  // smaller ranges are one task
  // Below this depth the children of a node have about equal numbers of primitives, so that a dozen more levels hold
  // 2^29 of them, whatever the scene.
  static constexpr int sah_depth = 40;

  Range Collect() {
    const std::uint32_t count = tree_.primitives.Size();
    references_ = HugeArray<Reference>(count);
    const auto add = [](Range a, const Range& b) {
      a.triangles += b.triangles, a.hulls += b.hulls;
      a.box.Extend(b.box);
      a.middles.Extend(b.middles);
      return a;
    };
    Range all = tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, tree_.primitives.Size(), parallel_from), Range(),
        [&](const auto& r, Range sum) {
          for (std::uint32_t i = r.begin(); i != r.end(); ++i) sum = add(sum, ReferTo(i));
          return sum;
        },
        add);
    all.begin = 0, all.end = count;
    return all;
  }

  Range ReferTo(std::uint32_t primitive) {
    const R3::Box bounds = tree_.primitives.Bounds(primitive);
    const auto rounded = [&](const R3::Point& p) {
      const R3::Vector v = tree_.coordinates(p);
      return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
    };
    Reference& reference = references_[primitive];
    reference.low = rounded(bounds.low), reference.high = rounded(bounds.high);
    Range one;
    one.box = reference.Box();
    one.middles.Extend(reference.Middle());
    reference.low[3] = std::bit_cast<float>(primitive ^ Reference::usual);
    reference.high[3] = Reference::AsFloat(LeafKindOf(tree_, primitive));
    one.triangles = reference.IsOf(Child::Kind::triangles) ? 1 : 0;
    one.hulls = reference.IsOf(Child::Kind::hulls) ? 1 : 0;
    return one;
  }

  bool IsLeaf(const Range& r) const {
    return r.Size() == 1 || (!r.IsMixed() && r.Size() <= (r.triangles > 0 ? leaf_ : MostOf(KindOf(r))));
  }
  /// Returns the kind of the first primitive, which is that of all in a range that is not mixed.
  Child::Kind KindOf(const Range& r) const { return references_[r.begin].Kind(); }

  /// Returns the cost of testing everything in a range, in block tests.
  float Tests(std::uint32_t triangles, std::uint32_t others) const {
    constexpr float price_of_other = 2;
    return static_cast<float>((triangles + leaf_ - 1) / leaf_) + price_of_other * static_cast<float>(others);
  }

  BuildNode* BuildNodeOf(const Range& whole, int depth) {
    std::array<Range, width> ranges{whole};
    std::size_t children = 1;
    while (children < width) {
      Range* next = nullptr;
      for (std::size_t i = 0; i < children; ++i)
        if (!IsLeaf(ranges[i]) && (!next || IsSplitBefore(ranges[i], *next, depth))) next = &ranges[i];
      if (!next) break;
      Halve(*next, ranges[children++], depth);
    }
    BuildNode* node = &nodes_.local().emplace_back();
    tbb::task_group tasks;
    bool has_tasks = false;
    for (std::size_t i = 0; i < children; ++i) {
      const Range& r = ranges[i];
      node->Add(IsLeaf(r) ? Leaf(r) : BuildChild{.box = r.box});
      if (IsLeaf(r)) continue;
      const BuildNode*& below = node->children[i].below;
      if (r.Size() >= parallel_from) {
        has_tasks = true;
        tasks.run([this, &r, &below, depth] { below = BuildNodeOf(r, depth + 1); });
      } else {
        below = BuildNodeOf(r, depth + 1);
      }
    }
    if (has_tasks) tasks.wait();
    return node;
  }

  /// Returns true if `a` is to be split before `b`: the one with the larger box, through which more rays pass. If boxes
  /// have nearly equal areas, and at great depth, the one with more primitives comes first, so that the children of a
  /// node become equally large.
  static bool IsSplitBefore(const Range& a, const Range& b, int depth) {
    constexpr float alike = 1 - 1.0f / 64;
    const float area = a.box.HalfArea(), other = b.box.HalfArea();
    const bool is_alike = std::min(area, other) >= alike * std::max(area, other);
    return depth < sah_depth && !is_alike ? area > other : a.Size() > b.Size();
  }

  BuildChild Leaf(const Range& range) const {
    BuildChild leaf{range.box, nullptr, KindOf(range), static_cast<int>(range.Size()), {}};
    for (std::uint32_t i = 0; i < range.Size(); ++i) leaf.primitives[i] = references_[range.begin + i].Primitive();
    return leaf;
  }

  /// Splits `whole` in two; it becomes the first half.
  void Halve(Range& whole, Range& second, int depth) {
    const std::uint32_t size = whole.Size();
    const Binning binning(whole.middles, size < 128 ? most_bins / 2 : most_bins);
    Split split;
    if (depth < sah_depth) split = BestSplit(whole, binning);
    if (split.axis < 0 || !Partition(whole, second, binning, split)) HalveByNumber(whole, second);
  }

  void FillBins(Bins& bins, const Binning& binning, std::uint32_t begin, std::uint32_t end) const {
    for (std::uint32_t i = begin; i != end; ++i) {
      const Reference& reference = references_[i];
      const Whole4 at = binning(reference.Middle());
#pragma GCC unroll 3
      for (int axis = 0; axis < 3; ++axis) bins.of[axis][at[axis]].Add(reference);
    }
  }

  Split BestSplit(const Range& whole, const Binning& binning) const {
    Bins bins(binning.count);
    constexpr std::uint32_t chunk = 1 << 16;
    if (whole.Size() < 4 * chunk) {
      FillBins(bins, binning, whole.begin, whole.end);
    } else {
      // Minima and integers: the sum does not depend on the order of addition.
      bins = tbb::parallel_reduce(
          tbb::blocked_range<std::uint32_t>(whole.begin, whole.end, chunk), Bins(binning.count),
          [&](const auto& r, Bins sum) {
            FillBins(sum, binning, r.begin(), r.end());
            return sum;
          },
          [&](Bins a, const Bins& b) {
            a.Add(b);
            return a;
          });
    }

    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (binning.IsFlat(axis)) continue;
      std::array<float, most_bins> behind;  // cost of bins i and up
      Bin sum;
      const auto cost_with = [&](int i) {
        sum.Add(bins.of[axis][i]);
        return sum.counts > 0 ? sum.box.HalfArea() * Tests(sum.Triangles(), sum.Others()) : infinity;
      };
      for (int i = binning.count - 1; i > 0; --i) behind[static_cast<std::size_t>(i)] = cost_with(i);
      sum = {};
      for (int i = 1; i < binning.count; ++i) {
        const float cost = cost_with(i - 1) + behind[static_cast<std::size_t>(i)];
        if (cost < best.cost) best = {cost, axis, i};
      }
    }
    return best;
  }

  /// Moves the references whose center is below the split to the front. Returns false if that would leave a side empty.
  bool Partition(Range& whole, Range& second, const Binning& binning, const Split& split) {
    const std::uint32_t begin = whole.begin, end = whole.end;
    Range first, rest;
    const auto is_first = [&](const Reference& r) {
      const float bin = (r.Middle()[split.axis] - binning.low[split.axis]) * binning.scale[split.axis];
      return std::min(static_cast<int>(bin), binning.count - 1) < split.bin;
    };
    std::uint32_t i = begin, k = end;
    while (true) {
      while (i < k && is_first(references_[i])) first.Extend(references_[i++]);
      while (i < k && !is_first(references_[k - 1])) rest.Extend(references_[--k]);
      if (i == k) break;
      std::swap(references_[i], references_[k - 1]);
    }
    first.begin = begin, first.end = rest.begin = i, rest.end = end;
    if (first.Size() == 0 || rest.Size() == 0) return false;
    whole = first, second = rest;
    return true;
  }

  /// Splits a range with coinciding centers, or in a tree that is too deep, into halves of equal size; a mixed range is
  /// split by kind.
  void HalveByNumber(Range& whole, Range& second) {
    const std::uint32_t begin = whole.begin, end = whole.end;
    int axis = 0;
    const Float4 size = whole.middles.high - whole.middles.low;
    for (int a = 1; a < 3; ++a)
      if (size[a] > size[axis]) axis = a;
    std::uint32_t middle = begin + whole.Size() / 2;
    const bool is_mixed = whole.IsMixed();
    const Child::Kind first_kind = whole.triangles > 0 ? Child::Kind::triangles : Child::Kind::hulls;
    if (is_mixed) middle = begin + (whole.triangles > 0 ? whole.triangles : whole.hulls);
    std::nth_element(references_.Data() + begin, references_.Data() + middle, references_.Data() + end,
                     [&](const Reference& a, const Reference& b) {
                       if (is_mixed && a.IsOf(first_kind) != b.IsOf(first_kind)) return a.IsOf(first_kind);
                       const float x = a.Middle()[axis], y = b.Middle()[axis];
                       return x != y ? x < y : a.Primitive() < b.Primitive();
                     });
    whole = RangeOf(begin, middle);
    second = RangeOf(middle, end);
  }

  Range RangeOf(std::uint32_t begin, std::uint32_t end) const {
    Range range;
    range.begin = begin, range.end = end;
    for (std::uint32_t i = begin; i != end; ++i) range.Extend(references_[i]);
    return range;
  }

  Tree& tree_;
  std::uint32_t leaf_;
  HugeArray<Reference> references_;
  tbb::enumerable_thread_specific<std::deque<BuildNode>> nodes_;  // a deque does not move its elements
};

}  // namespace

Tree Build(PrimitiveSet primitives, int leaf_size) {
  Tree tree(std::move(primitives));
  Builder(tree, leaf_size).Run();
  return tree;
}

}  // namespace ray::wide
