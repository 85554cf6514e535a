#include <algorithm>
#include <cmath>
#include <numeric>

#include "source/accelerate/Cells.h"

// Highway compiles this file once for each instruction set. What does not depend on that is included before.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "source/accelerate/kinds/grid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "source/accelerate/Search-inl.h"

#ifndef RAY_ACCELERATE_GRID
#define RAY_ACCELERATE_GRID
namespace ray {

/// Equal cells in rows, columns and layers; cells that hold very many items have a grid of their own.
struct Grid {
  static constexpr bool meets_items_again = true;

  /// One grid: cell (x, y, z) is cells[first + (z rows + y) columns + x].
  struct Level {
    Cell box;
    R3::Vector size;  // of a cell
    std::array<int, 3> count{1, 1, 1};
    std::size_t first = 0;
  };
  static constexpr std::uint32_t is_level = ~0u;  // in Contents::blocks: first_block is the level inside

  explicit Grid(Space the_space) : space(std::move(the_space)) {}

  Space space;
  Coordinates coordinates;
  std::vector<Level> levels;  // the outermost first
  std::vector<Contents> cells;
  CellContents contents;
  std::uint64_t references = 0;

  std::size_t Bytes() const {
    return space.Bytes() + contents.Bytes() + cells.capacity() * sizeof(Contents) + levels.capacity() * sizeof(Level);
  }
  std::string Explain() const {
    const auto& count = levels[0].count;
    return std::to_string(count[0]) + " x " + std::to_string(count[1]) + " x " + std::to_string(count[2]) +
           " cells and " + std::to_string(levels.size() - 1) + " grids inside them, " + std::to_string(references) +
           " references";
  }
};

}  // namespace ray
#endif

HWY_BEFORE_NAMESPACE();
namespace ray {
namespace HWY_NAMESPACE {

/// From cell to cell in the order of the ray; true when the search is over.
///   source  Amanatides, Woo, A fast voxel traversal algorithm for ray tracing (1987)
template <typename Asker>
bool WalkLevel(const Grid& grid, const Grid::Level& level, const Probe& probe, double enter, double leave, Asker& asker,
               std::uint64_t& visits) {
  std::array<double, 3> next, step;
  std::array<int, 3> at, onward, end;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double d =
        std::abs(probe.along[axis]) < 0x1p-40 ? std::copysign(0x1p-40, probe.along[axis]) : probe.along[axis];
    const double low = FromOrigin(level.box.low)[axis], size = level.size[axis];
    const double place = (probe.start[axis] + enter * d - low) / size;
    at[a] = place > 0 ? std::min(static_cast<int>(std::min(place, 1e9)), level.count[a] - 1) : 0;
    onward[a] = d > 0 ? 1 : -1;
    end[a] = d > 0 ? level.count[a] : -1;
    next[a] = (low + (at[a] + (d > 0 ? 1 : 0)) * size - probe.start[axis]) / d;
    step[a] = size / std::abs(d);
  }
  double entry = enter;
  while (true) {
    const std::size_t a = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const Contents& contents = grid.cells[level.first +
                                          (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(level.count[1]) +
                                           static_cast<std::size_t>(at[1])) *
                                              static_cast<std::size_t>(level.count[0]) +
                                          static_cast<std::size_t>(at[0])];
    ++visits;
    if (contents.blocks == Grid::is_level) {
      if (WalkLevel(grid, grid.levels[contents.first_block], probe, entry, std::min(next[a], leave), asker, visits))
        return true;
    } else if (AskContents(grid.contents, contents, asker)) {
      return true;
    }
    // What is nearer than the way out has been met: it lies, widened, in the cells up to here.
    if (static_cast<double>(asker.limit) < next[a]) return true;
    if (next[a] > leave) return false;
    at[a] += onward[a];
    if (at[a] == end[a]) return false;
    entry = next[a];
    next[a] += step[a];
  }
}

template <bool any, typename Asker>
void Walk(const Grid& grid, const Probe& probe, Asker& asker, Counts& counts) {
  if (grid.levels.empty()) return;
  if (!(static_cast<double>(probe.slack) <= cell_pad / 2)) {
    AskContents(grid.contents, grid.contents.All(), asker);
    return;
  }
  const Grid::Level& level = grid.levels[0];
  double enter = 0, leave = asker.limit;
  for (int axis = 0; axis < 3; ++axis) {
    const double d =
        std::abs(probe.along[axis]) < 0x1p-40 ? std::copysign(0x1p-40, probe.along[axis]) : probe.along[axis];
    const double a = (FromOrigin(level.box.low)[axis] - probe.start[axis]) / d;
    const double b = (FromOrigin(level.box.high)[axis] - probe.start[axis]) / d;
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return;
  std::uint64_t visits = 0;
  WalkLevel(grid, level, probe, enter, leave, asker, visits);
  counts.node_visits += visits;
}

void ChooseGrid(Kernels<Grid>* kernels) { *kernels = CompiledKernels<Grid>(); }

}  // namespace HWY_NAMESPACE
}  // namespace ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ray {
namespace {

HWY_EXPORT(ChooseGrid);

constexpr double usual_density = 0.05;  // cells an item: blocks of eight want full cells (bench/kernels)
constexpr std::size_t crowd = 64;       // items of a cell that are worth a grid of their own
constexpr int most_levels = 3;          // one inside the other
constexpr double most_cells = 1 << 25;
constexpr double most_on_an_axis = 1 << 14;

class GridBuilder {
 public:
  GridBuilder(Grid& grid, double density) : grid_(grid), density_(density) {}

  void Run() {
    const std::uint32_t count = grid_.space.Items();
    if (count == 0) return;
    grid_.coordinates = FitCoordinates(grid_.space);
    items_.reserve(count);
    Cell box{R3::Point{R3::infinity, R3::infinity, R3::infinity},
             R3::Point{-R3::infinity, -R3::infinity, -R3::infinity}};
    for (std::uint32_t i = 0; i < count; ++i) {
      const Cell& of = items_.emplace_back(grid_.space, grid_.coordinates, i).Box();
      box.low = {std::min(box.low.x, of.low.x), std::min(box.low.y, of.low.y), std::min(box.low.z, of.low.z)};
      box.high = {std::max(box.high.x, of.high.x), std::max(box.high.y, of.high.y), std::max(box.high.z, of.high.z)};
    }
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    most_references_ = 12 * static_cast<std::uint64_t>(count) + 4096;
    Divide(box, all, 1);
    grid_.contents.Close();
  }

 private:
  using List = std::vector<std::uint32_t>;

  /// Returns the level's number.
  std::uint32_t Divide(const Cell& box, const List& items, int depth) {
    const auto number = static_cast<std::uint32_t>(grid_.levels.size());
    grid_.levels.emplace_back();
    Grid::Level level;
    level.box = box;
    std::vector<std::uint32_t> starts;
    List references;
    double cells = std::clamp(density_ * static_cast<double>(items.size()), 1.0, most_cells);
    while (true) {  // until what is long and slanted does not fill the memory
      SetCounts(level, cells);
      if (Sort(level, items, starts, references)) break;
      cells /= 4;
    }
    level.first = grid_.cells.size();
    const std::size_t count = starts.size() - 1;
    grid_.cells.resize(level.first + count);
    grid_.levels[number] = level;
    for (std::size_t c = 0; c < count; ++c) {
      const std::span<const std::uint32_t> in_cell(references.data() + starts[c], starts[c + 1] - starts[c]);
      Contents contents;
      if (in_cell.size() > crowd && count > 1 && depth < most_levels &&
          sorted_references_ + 2 * in_cell.size() < most_references_) {
        contents.first_block = Divide(BoxOf(level, c), List(in_cell.begin(), in_cell.end()), depth + 1);
        contents.blocks = Grid::is_level;
      } else {
        contents = grid_.contents.Add(grid_.space, grid_.coordinates, in_cell);
        grid_.references += in_cell.size();
      }
      grid_.cells[level.first + c] = contents;
    }
    return number;
  }

  /// About so many cells, as near to cubes as can be.
  static void SetCounts(Grid::Level& level, double cells) {
    const R3::Vector size = level.box.high - level.box.low;
    const double longest = MaxComponent(size);
    // Flat axes first: what they cannot take is left to the others.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return size[static_cast<int>(a)] < size[static_cast<int>(b)]; });
    double left = cells;
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis) volume *= std::max(size[axis] / longest, 1e-6);
    int axes = 3;
    for (const std::size_t a : order) {
      const double share = std::max(size[static_cast<int>(a)] / longest, 1e-6);
      const double wanted = share * std::pow(left / volume, 1.0 / axes);
      level.count[a] = static_cast<int>(std::clamp(std::round(wanted), 1.0, most_on_an_axis));
      left = std::max(1.0, left / level.count[a]);
      volume /= share;
      --axes;
    }
    level.size = {size.x / level.count[0], size.y / level.count[1], size.z / level.count[2]};
  }

  static Cell BoxOf(const Grid::Level& level, std::size_t c) {
    const auto columns = static_cast<std::size_t>(level.count[0]), rows = static_cast<std::size_t>(level.count[1]);
    const auto x = static_cast<double>(c % columns), y = static_cast<double>(c / columns % rows),
               z = static_cast<double>(c / columns / rows);
    const R3::Point low = level.box.low + R3::Vector{x * level.size.x, y * level.size.y, z * level.size.z};
    return {low, low + level.size};
  }

  /// The items of every cell, one cell after the other: those of cell c from starts[c] to starts[c + 1]. False when
  /// there are too many.
  bool Sort(const Grid::Level& level, const List& items, std::vector<std::uint32_t>& starts, List& references) {
    struct Reference {
      std::uint32_t cell, item;
    };
    std::vector<Reference> found;
    const auto cells = static_cast<std::size_t>(level.count[0]) * static_cast<std::size_t>(level.count[1]) *
                       static_cast<std::size_t>(level.count[2]);
    for (const std::uint32_t item : items) {
      const CellItem& of = items_[item];
      std::array<int, 3> low, high;
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const auto place = [&](const R3::Point& p) {
          const double cell = (FromOrigin(p)[axis] - FromOrigin(level.box.low)[axis]) / level.size[axis];
          return static_cast<int>(std::clamp(std::floor(cell), 0.0, static_cast<double>(level.count[a] - 1)));
        };
        low[a] = place(of.Box().low), high[a] = place(of.Box().high);
      }
      for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int x = low[0]; x <= high[0]; ++x) {
            const std::size_t c =
                (static_cast<std::size_t>(z) * static_cast<std::size_t>(level.count[1]) + static_cast<std::size_t>(y)) *
                    static_cast<std::size_t>(level.count[0]) +
                static_cast<std::size_t>(x);
            if (low != high && !of.MayTouch(BoxOf(level, c))) continue;
            if (sorted_references_ + found.size() >= most_references_ && cells > 1) return false;
            found.push_back({static_cast<std::uint32_t>(c), item});
          }
    }
    sorted_references_ += found.size();
    starts.assign(cells + 1, 0);
    for (const Reference& r : found) ++starts[r.cell + 1];
    for (std::size_t c = 0; c < cells; ++c) starts[c + 1] += starts[c];
    references.resize(found.size());
    std::vector<std::uint32_t> ends(starts.begin(), starts.end() - 1);
    for (const Reference& r : found) references[ends[r.cell]++] = r.item;
    return true;
  }

  Grid& grid_;
  double density_;
  std::uint64_t most_references_ = 0, sorted_references_ = 0;  // on all levels together
  std::vector<CellItem> items_;
};

}  // namespace

extern const AcceleratorKind grid_kind{
    "grid", "equal cells, crowded ones divided again: for hair, thin and slanted things",
    [](const World& world, const AcceleratorSettings& settings) -> std::unique_ptr<const Accelerator> {
      const double density = settings.resolution > 0 ? settings.resolution : usual_density;
      return std::make_unique<ForestAccelerator<Grid>>(
          world, settings,
          [](void* kernels) { HWY_DYNAMIC_DISPATCH(ChooseGrid)
                              (static_cast<Kernels<Grid>*>(kernels)); },
          [&](Space space) {
            Grid grid(std::move(space));
            GridBuilder(grid, density).Run();
            return grid;
          });
    }};

}  // namespace ray
#endif
