#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "R1/Elementary.h"
#include "R1/Targets.h"
#include "source/accelerate/wide/ClippedPrimitive.h"
#include "source/text/Words.h"

// Highway compiles this file once per instruction set. Everything independent of that is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/grid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "source/accelerate/wide/Traverse-inl.h"

#ifndef RAY_ACCELERATE_GRID
#define RAY_ACCELERATE_GRID
namespace ray {

/// The padding, in the structure's coordinates, with which ClippedPrimitives are assigned to every cell that they
/// touch. It covers the plane error of every ray for which that error is at most half of it; other rays test
/// everything.
inline constexpr double cell_padding = 0x1p-17;

/// Equal cells in rows, columns and layers; cells that contain very many primitives have their own grid. The contents
/// of a cell are a child of a tree of boxes.
struct Grid : wide::Tree {
  static constexpr bool meets_primitives_again = true;

  /// One grid: cell (x, y, z) is cells[first + (z rows + y) columns + x].
  struct Level {
    R3::Box box;
    R3::Vector size;  // of a cell
    std::array<int, 3> count{1, 1, 1};
    std::size_t first = 0;

    std::size_t Cells() const {
      return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
             static_cast<std::size_t>(count[2]);
    }
    std::size_t Cell(const std::array<int, 3>& at) const {
      return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(at[1])) *
                 static_cast<std::size_t>(count[0]) +
             static_cast<std::size_t>(at[0]);
    }
    R3::Box BoxOf(std::size_t cell) const {
      const auto columns = static_cast<std::size_t>(count[0]), rows = static_cast<std::size_t>(count[1]);
      const auto x = static_cast<double>(cell % columns), y = static_cast<double>(cell / columns % rows),
                 z = static_cast<double>(cell / columns / rows);
      const R3::Point low = box.low + R3::Vector{x * size.x, y * size.y, z * size.z};
      return {low, low + size};
    }
  };

  using Tree::Tree;

  std::vector<Level> levels;  // the outermost level first
  /// Children of the tree. A `nothing` child with an index contains the level of that number.
  std::vector<std::uint32_t> cells;

  /// Returns the level inside a cell; 0 if there is none, since level 0 is never inside a cell.
  static std::uint32_t LevelInside(std::uint32_t cell) {
    return wide::Child::IsNothing(cell) ? cell - wide::Child::nothing : 0;
  }
  static std::uint32_t CellWithLevel(std::uint32_t level) { return wide::Child::nothing + level; }

  /// Returns 0, since cells are not nested boxes.
  int BoxLevels() const { return 0; }
  std::vector<R3::Box> BoxesAt(int) const { return {}; }

  std::size_t Bytes() const {
    return Tree::Bytes() + cells.capacity() * sizeof(std::uint32_t) + levels.capacity() * sizeof(Level);
  }
  std::string Explain() const {
    if (levels.empty()) return "no cells";
    const auto& count = levels[0].count;
    return std::to_string(count[0]) + " x " + std::to_string(count[1]) + " x " + std::to_string(count[2]) +
           " cells and " + Counted(levels.size() - 1, "grid") + " inside them, " +
           Counted(static_cast<std::uint64_t>(blocks), "block") + " of triangles";
  }
};

}  // namespace ray
#endif

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// Traverses the cells of all levels.
template <bool any, typename LeafVisitor>
class GridTraversal {
 public:
  HWY_INLINE GridTraversal(const Grid& grid, const TraversalRay& ray, LeafVisitor& visitor, Counts& counts)
      : grid_(grid), ray_(ray), visitor_(visitor), counts_(counts), node_ray_(ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.along[axis];
      along_[axis] = std::abs(d) < flattest ? std::copysign(double{flattest}, d) : d;
    }
  }

  void Run() {
    if (!(static_cast<double>(ray_.plane_error) <= cell_padding / 2)) {
      for (const std::uint32_t cell : grid_.cells)
        if (Visit(cell)) return;
      return;
    }
    const Grid::Level& level = grid_.levels[0];
    double enter = 0, leave = visitor_.limit;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (FromOrigin(level.box.low)[axis] - ray_.start[axis]) / along_[axis];
      const double b = (FromOrigin(level.box.high)[axis] - ray_.start[axis]) / along_[axis];
      enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
    }
    if (enter <= leave) Through(level, enter, leave);
    counts_.node_visits += visits_;
  }

 private:
  /// Visits the contents of a cell; returns true if that ends the search.
  HWY_INLINE bool Visit(std::uint32_t cell) {
    if (wide::Child::KindOf(cell) == wide::Child::Kind::triangles)
      return visitor_.VisitTriangles(grid_.At<TriangleBlock>(cell));
    return !wide::Child::IsNothing(cell) && VisitSubtree(cell);
  }
  HWY_NOINLINE bool VisitSubtree(std::uint32_t cell) {
    TraverseFrom<any>(cell, grid_, node_ray_, visitor_, counts_);
    return visitor_.is_answered;
  }

  /// Moves from cell to cell in the order of the ray by 3D-DDA; returns true if the search is over.
  ///   source  Amanatides, Woo, A fast voxel traversal algorithm for ray tracing (1987)
  bool Through(const Grid::Level& level, double enter, double leave) {
    std::array<double, 3> next, step;
    std::array<int, 3> at, onward, end;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double d = along_[axis], low = FromOrigin(level.box.low)[axis], size = level.size[axis];
      const double cell = (ray_.start[axis] + enter * d - low) / size;
      at[a] = cell > 0 ? std::min(static_cast<int>(std::min(cell, 1e9)), level.count[a] - 1) : 0;
      onward[a] = d > 0 ? 1 : -1;
      end[a] = d > 0 ? level.count[a] : -1;
      next[a] = (low + (at[a] + (d > 0 ? 1 : 0)) * size - ray_.start[axis]) / d;
      step[a] = size / std::abs(d);
    }
    double entry = enter;
    while (true) {
      const std::size_t a = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      const std::uint32_t cell = grid_.cells[level.first + level.Cell(at)];
      ++visits_;
      if (const std::uint32_t inside = Grid::LevelInside(cell)) {
        if (Through(grid_.levels[inside], entry, std::min(next[a], leave))) return true;
      } else if (Visit(cell)) {
        return true;
      }
      // Hits nearer than the exit have been found: they lie, padded, in the cells up to here.
      if (static_cast<double>(visitor_.limit) < next[a]) return true;
      if (next[a] > leave) return false;
      at[a] += onward[a];
      if (at[a] == end[a]) return false;
      entry = next[a];
      next[a] += step[a];
    }
  }

  const Grid& grid_;
  const TraversalRay& ray_;
  LeafVisitor& visitor_;
  Counts& counts_;
  NodeRay node_ray_;
  double along_[3];  // no component is flatter than `flattest`
  std::uint64_t visits_ = 0;
};

template <bool any, typename LeafVisitor>
void Traverse(const Grid& grid, const TraversalRay& ray, LeafVisitor& visitor, Counts& counts) {
  if (!grid.levels.empty()) GridTraversal<any, LeafVisitor>(grid, ray, visitor, counts).Run();
}

void ChooseGrid(Kernels<Grid>* kernels) { *kernels = CompiledKernels<Grid>(); }

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

using wide::ClippedPrimitive;
using wide::ClippedPrimitives;

HWY_EXPORT(ChooseGrid);

constexpr double usual_density = 0.03;  // cells per primitive; nodes of full blocks suit full cells (bench/kernels)
// Primitives that average this many references in cells of that size are long: finer cells separate them better.
constexpr double long_from = 3, finer = 10;
constexpr std::size_t crowd = 64;   // number of primitives in a cell that is worth a grid of its own
constexpr int most_levels = 3;      // of nested grids
constexpr double most_growth = 12;  // total references per primitive, on all levels together
constexpr double most_cells = 1 << 25;
constexpr double most_on_an_axis = 1 << 14;

class GridBuilder {
 public:
  GridBuilder(Grid& grid, double density, double most_seconds)
      : grid_(grid), density_(density), most_seconds_(most_seconds) {}

  void Run() {
    const std::uint32_t count = grid_.primitives.Size();
    if (count == 0) return;
    grid_.coordinates = FitCoordinates(grid_.primitives);
    ClippedPrimitives all(count);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) { all[i] = Unclipped(grid_, i); });
    R3::Box box;
    for (const ClippedPrimitive& primitive : all) box.Extend(Widened(primitive.box));
    Divide(box, all, 1, most_growth);
    const std::vector<std::uint32_t> children = wide::Flatten(children_, grid_);
    for (std::size_t c = 0; c < grid_.cells.size(); ++c)
      if (!children_[c].IsEmpty()) grid_.cells[c] = children[c];
  }

 private:
  static R3::Box Widened(const wide::Extent& box) {
    const auto point = [](wide::Float4 p, double padding) {
      return R3::Point{p[0] + padding, p[1] + padding, p[2] + padding};
    };
    return {point(box.low, -cell_padding), point(box.high, cell_padding)};
  }

  /// The primitives of every cell in order: those of cell c from starts[c] to starts[c + 1].
  struct Sorted {
    std::vector<std::uint32_t> starts;
    ClippedPrimitives primitives;
  };

  /// Returns the level's number. `growth` limits the references made per given primitive.
  std::uint32_t Divide(const R3::Box& box, const ClippedPrimitives& primitives, int depth, double growth) {
    const auto number = static_cast<std::uint32_t>(grid_.levels.size());
    Grid::Level level;
    level.box = box;
    const double count = static_cast<double>(primitives.size());
    Sorted sorted = ChooseCells(level, primitives, growth * count, depth == 1 && density_ == usual_density);
    level.first = grid_.cells.size();
    grid_.levels.push_back(level);
    grid_.cells.resize(level.first + level.Cells(), Grid::CellWithLevel(0));
    children_.resize(grid_.cells.size());
    const double left = growth * count / std::max(1.0, static_cast<double>(sorted.primitives.size()));
    for (std::size_t c = 0; c < level.Cells(); ++c) {
      Work();
      const std::span<ClippedPrimitive> inside(sorted.primitives.data() + sorted.starts[c],
                                               sorted.starts[c + 1] - sorted.starts[c]);
      if (inside.size() > crowd && level.Cells() > 1 && depth < most_levels && left > 1.5) {
        const std::uint32_t below = Divide(level.BoxOf(c), {inside.begin(), inside.end()}, depth + 1, left);
        grid_.cells[level.first + c] = Grid::CellWithLevel(below);
      } else {
        children_[level.first + c] = subtrees_.Build(inside);
      }
    }
    return number;
  }

  /// Sets the number of cells of the level by the density: fewer if long, slanted primitives would fill the memory, and
  /// more for long ones if `may_be_finer`.
  Sorted ChooseCells(Grid::Level& level, const ClippedPrimitives& primitives, double most, bool may_be_finer) {
    const double count = static_cast<double>(primitives.size());
    double cells = std::clamp(density_ * count, 1.0, most_cells);
    while (true) {
      SetCounts(level, cells);
      std::optional<Sorted> sorted = Sort(level, primitives, most);
      if (!sorted) {
        cells /= 4;
        continue;
      }
      const auto references = static_cast<double>(sorted->primitives.size());
      if (level.Cells() > 1 && references > count * static_cast<double>(level.Cells()) / 2) {
        cells = 1;  // cells do not separate the primitives
      } else if (may_be_finer && references > long_from * count) {
        may_be_finer = false;
        cells = std::min(cells * finer, most_cells);
      } else {
        return std::move(*sorted);
      }
    }
  }

  /// Sets about this many cells, as close to cubes as possible.
  static void SetCounts(Grid::Level& level, double cells) {
    const R3::Vector size = level.box.high - level.box.low;
    const double longest = MaxComponent(size);
    // Flat axes first: the other axes take the cells that they cannot use.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return size[static_cast<int>(a)] < size[static_cast<int>(b)]; });
    double left = cells;
    // No share of the longest side is 0: boxes are padded by cell_padding, and cells are hardly flatter than the box
    // that they divide.
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis) volume *= size[axis] / longest;
    int axes = 3;
    for (const std::size_t a : order) {
      const double share = size[static_cast<int>(a)] / longest;
      const double wanted = share * R1::Pow(left / volume, 1.0 / axes);
      level.count[a] = static_cast<int>(std::clamp(std::round(wanted), 1.0, most_on_an_axis));
      left = std::max(1.0, left / level.count[a]);
      volume /= share;
      --axes;
    }
    level.size = {size.x / level.count[0], size.y / level.count[1], size.z / level.count[2]};
  }

  /// Sorts the primitives into cells; std::nullopt if there are more than `most`.
  std::optional<Sorted> Sort(const Grid::Level& level, const ClippedPrimitives& primitives, double most) const {
    std::vector<std::pair<std::size_t, ClippedPrimitive>> found;  // with their cells
    for (const ClippedPrimitive& primitive : primitives) {
      const R3::Box widened = Widened(primitive.box);
      std::array<int, 3> low, high, at;
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const auto cell_of = [&](const R3::Point& p) {
          const double cell = (FromOrigin(p)[axis] - FromOrigin(level.box.low)[axis]) / level.size[axis];
          return static_cast<int>(std::clamp(std::floor(cell), 0.0, static_cast<double>(level.count[a] - 1)));
        };
        low[a] = cell_of(widened.low), high[a] = cell_of(widened.high);
      }
      for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
        for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
          for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) {
            const std::size_t cell = level.Cell(at);
            Work();
            ClippedPrimitive inside = primitive;
            if (low != high && !ClipTo(WithPadding(level.BoxOf(cell)), grid_, inside)) continue;
            found.emplace_back(cell, inside);
            if (static_cast<double>(found.size()) > most && level.Cells() > 1) return {};
          }
    }
    Sorted sorted;
    sorted.starts.assign(level.Cells() + 1, 0);
    for (const auto& [cell, primitive] : found) ++sorted.starts[cell + 1];
    for (std::size_t c = 0; c < level.Cells(); ++c) sorted.starts[c + 1] += sorted.starts[c];
    sorted.primitives.resize(found.size());
    std::vector<std::uint32_t> ends(sorted.starts.begin(), sorted.starts.end() - 1);
    for (const auto& [cell, primitive] : found) sorted.primitives[ends[cell]++] = primitive;
    return sorted;
  }

  /// Counts a unit of work, which may take up to a microsecond; throws when time is up.
  void Work() const {
    constexpr std::uint64_t units_per_look = 256;
    if (++work_ % units_per_look == 0 &&
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() > most_seconds_)
      throw BuildTookTooLong();
  }

  static R3::Box WithPadding(const R3::Box& cell) {
    const R3::Vector padding{cell_padding, cell_padding, cell_padding};
    return {cell.low - padding, cell.high + padding};
  }

  Grid& grid_;
  double density_, most_seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  mutable std::uint64_t work_ = 0;
  std::vector<wide::BuildChild> children_;  // of each cell
  wide::SubtreeBuilder subtrees_;
};

}  // namespace

extern const AcceleratorKind grid_kind{
    "grid", "equal cells, crowded ones divided again: for hair, thin and slanted things",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<Accelerator> {
      const double density = settings.resolution > 0 ? settings.resolution : usual_density;
      return std::make_unique<TwoLevelAccelerator<Grid>>(
          world, settings,
          [](void* kernels) {
            HWY_DYNAMIC_DISPATCH(ChooseGrid)
            (static_cast<Kernels<Grid>*>(kernels));
          },
          [&](PrimitiveSet primitives) {
            Grid grid(std::move(primitives));
            GridBuilder(grid, density, settings.most_build_seconds).Run();
            return grid;
          });
    }};

}  // namespace ray
#endif
