#include "source/inspect/CrossSection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace ray {
namespace {

double Cross(const R2::Vector& a, const R2::Vector& b) { return a.x * b.y - a.y * b.x; }

Slice Around(const R3::Point& on_plane, const R3::Vector& u, const R3::Vector& v, const R3::Box& scene) {
  constexpr double margin = 1.05;
  const DrawingSpace space = DrawingSpace::Of(scene);
  Slice slice{on_plane, u, v, margin * space.radius};
  slice.center = slice.InWorld(slice.Project(space.center));
  return slice;
}

// Lines do not lie evenly about the middle, so that they miss each other's crossings and the round numbers that scenes
// are made of: a curve through the very corner of four cells would be found in none of them.
constexpr double column_shift = 0.41421356, row_shift = 0.61803399;

/// Lines `size` apart along both axes.
struct Grid {
  double extent, size;
  int lines;

  double Column(int i) const { return -extent + (i + column_shift) * size; }
  double Row(int i) const { return -extent + (i + row_shift) * size; }
  /// The last line at or below; -1 before the first.
  int ColumnBelow(double x) const { return LineBelow((x + extent) / size - column_shift); }
  int RowBelow(double y) const { return LineBelow((y + extent) / size - row_shift); }
  int LineBelow(double at) const { return static_cast<int>(std::clamp(std::floor(at), -1.0, lines - 1.0)); }
};

/// Finds the crossings of grid lines.
class Search {
 public:
  Search(const World& world, const Accelerator& accelerator, SceneCut& cut)
      : world_(world), accelerator_(accelerator), cut_(cut) {}

  /// Returns the ray from `start` in `direction` to the end of the slice.
  void Along(const R2::Point& start, const R3::Vector& direction) {
    R3::Ray ray{cut_.slice.InWorld(start), direction, 0, 2 * cut_.slice.extent};
    std::optional<Found> last;
    for (int i = 0; i < most_crossings; ++i) {
      const auto hit = accelerator_.Intersect(ray, workspace_);
      if (!hit) return;
      Found found{*hit, world_.At(ray, *hit), false};
      found.enters = Dot(found.at.normal, direction) < 0;
      // Where two triangles meet, both may be hit, one after the other.
      if (!(last && IsSame(*last, found))) Add(found);
      last = found;
      ray.t_min = hit->t;  // t strictly grows, so this ends
    }
    ++cut_.lines_given_up;
  }

 private:
  struct Found {
    WorldHit hit;
    R3::Intersection at;
    bool enters;
  };

  static bool IsSame(const Found& a, const Found& b) {
    return a.hit.instance == b.hit.instance && a.enters == b.enters &&
           Length(a.at.position - b.at.position) <= Length(a.at.error) + Length(b.at.error);
  }

  void Add(const Found& found) {
    cut_.crossings.push_back({cut_.slice.Project(found.at.position), found.at.position,
                              cut_.slice.Project(AsVector(found.at.normal)), found.hit.instance, found.enters});
  }

  const World& world_;
  const Accelerator& accelerator_;
  SceneCut& cut_;
  Workspace workspace_;
};

enum class Side { lower, upper, left, right };  // of a cell

/// A crossing as one of the two cells at its grid line sees it.
struct Visit {
  std::uint64_t cell = 0;
  std::uint32_t instance = 0, crossing = 0;
  Side side = Side::lower;
  bool goes_in = false;  // whether the curve, with the inside on its left, comes into the cell here

  friend bool operator<(const Visit& a, const Visit& b) {
    return a.cell != b.cell           ? a.cell < b.cell
           : a.instance != b.instance ? a.instance < b.instance
                                      : a.crossing < b.crossing;
  }
};

/// Joins crossings on the sides of the same cell.
class Joining {
 public:
  Joining(SceneCut& cut, const Grid& grid) : cut_(cut), grid_(grid) {}

  /// Visits the cells above and below a crossing on a row. With the inside to the left, a curve goes up where the row
  /// leaves the inside to its left, that is, where it leaves the shape.
  void VisitRow(std::uint32_t crossing, int row) {
    const Crossing& c = cut_.crossings[crossing];
    const int column = grid_.ColumnBelow(c.on_slice.x);
    visits_.push_back({CellAt(column, row), c.instance, crossing, Side::lower, !c.enters});
    visits_.push_back({CellAt(column, row - 1), c.instance, crossing, Side::upper, c.enters});
  }
  /// Visits the cells to the right and to the left of a crossing on a column.
  void VisitColumn(std::uint32_t crossing, int column) {
    const Crossing& c = cut_.crossings[crossing];
    const int row = grid_.RowBelow(c.on_slice.y);
    visits_.push_back({CellAt(column, row), c.instance, crossing, Side::left, c.enters});
    visits_.push_back({CellAt(column - 1, row), c.instance, crossing, Side::right, !c.enters});
  }

  void Run() {
    std::sort(visits_.begin(), visits_.end());
    for (std::size_t i = 0, end = 0; i < visits_.size(); i = end) {
      while (end < visits_.size() && visits_[end].cell == visits_[i].cell &&
             visits_[end].instance == visits_[i].instance)
        ++end;
      Join(std::span(visits_).subspan(i, end - i));
    }
  }

 private:
  std::uint64_t CellAt(int column, int row) const {
    return static_cast<std::uint64_t>(row + 1) * static_cast<std::uint64_t>(grid_.lines + 1) +
           static_cast<std::uint64_t>(column + 1);
  }

  /// Joins the crossings around a cell: two with each other, more in pairs of a way in and a way out, straightest
  /// first. Any others, as at the rim of an open surface, stay alone.
  void Join(std::span<const Visit> visits) {
    if (visits.size() == 2) return Add(visits[0].crossing, visits[1].crossing);
    constexpr std::size_t most = 64;  // more in one cell is no curve any more
    if (visits.size() < 2 || visits.size() > most) return;
    struct Pair {
      double bend;
      std::size_t in, out;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < visits.size(); ++i)
      for (std::size_t k = 0; k < visits.size(); ++k)
        if (visits[i].goes_in && !visits[k].goes_in) pairs.push_back({Bend(visits[i], visits[k]), i, k});
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.bend < b.bend; });
    std::array<bool, most> is_joined{};
    for (const Pair& pair : pairs) {
      if (is_joined[pair.in] || is_joined[pair.out]) continue;
      is_joined[pair.in] = is_joined[pair.out] = true;
      Add(visits[pair.in].crossing, visits[pair.out].crossing);
    }
  }

  /// The sines of the angles from the way between two crossings to the tangents at both; 0 where it goes straight on.
  /// By angles, not by distances, so that the sides of however thin a plate are not taken for its ends. To the side it
  /// came from a curve goes back only if there is no better way.
  double Bend(const Visit& a, const Visit& b) const {
    const Crossing &p = cut_.crossings[a.crossing], &q = cut_.crossings[b.crossing];
    const R2::Vector way = q.on_slice - p.on_slice;
    const double length = std::sqrt(Dot(way, way));
    const auto off = [&](const R2::Vector& normal) {
      const double both = length * std::sqrt(Dot(normal, normal));
      return both > 0 ? std::abs(Dot(way, normal)) / both : 0;
    };
    return off(p.normal) + off(q.normal) + (a.side == b.side ? 1 : 0);
  }

  void Add(std::uint32_t from, std::uint32_t to) { cut_.pieces.push_back({from, to, Corner(from, to)}); }

  /// Returns the point in which the tangents meet, if they do so at an angle and within a cell of both.
  std::optional<R2::Point> Corner(std::uint32_t from, std::uint32_t to) const {
    const Crossing &p = cut_.crossings[from], &q = cut_.crossings[to];
    const double turn = Cross(p.normal, q.normal);
    constexpr double least_sine = 0.35;  // about 20 degrees; smooth curves bend less from line to line
    const double lengths = std::sqrt(Dot(p.normal, p.normal) * Dot(q.normal, q.normal));
    if (!(std::abs(turn) > least_sine * lengths)) return {};
    // p + x with normal_p . x = 0 and normal_q . x = normal_q . (q - p).
    const double along = Dot(q.normal, q.on_slice - p.on_slice) / turn;
    const R2::Point corner = p.on_slice + along * R2::Vector{-p.normal.y, p.normal.x};
    const auto is_near = [&](const R2::Point& a) {
      return std::max(std::abs(corner.x - a.x), std::abs(corner.y - a.y)) <= grid_.size;
    };
    if (!is_near(p.on_slice) || !is_near(q.on_slice)) return {};
    return corner;
  }

  SceneCut& cut_;
  const Grid& grid_;
  std::vector<Visit> visits_;
};

}  // namespace

Slice AxisSlice(SlicePlane plane, const R3::Point& through, const R3::Box& scene) {
  const R3::Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  switch (plane) {
    case SlicePlane::xz:
      return Around(through, x, z, scene);
    case SlicePlane::yz:
      return Around(through, z, y, scene);
    case SlicePlane::xy:
      return Around(through, x, y, scene);
    case SlicePlane::camera_row:
      break;
  }
  assert(false);
  return Around(through, x, y, scene);
}

Slice CameraSlice(const Camera& camera, double y, int width, int height, const R3::Box& scene) {
  const R3::Ray middle = camera.Through(width / 2.0, y, width, height);
  return Around(camera.eye, camera.right, Unit(middle.direction), scene);
}

SceneCut CutOf(const World& world, const Accelerator& accelerator, const Slice& slice, int lines) {
  lines = std::max(lines, 2);
  SceneCut cut{slice, {}, {}, 0};
  const Grid grid{slice.extent, 2 * slice.extent / lines, lines};
  Search search(world, accelerator, cut);
  Joining joining(cut, grid);
  for (int row = 0; row < lines; ++row) {
    auto next = static_cast<std::uint32_t>(cut.crossings.size());
    search.Along({-slice.extent, grid.Row(row)}, slice.u);
    for (; next < cut.crossings.size(); ++next) joining.VisitRow(next, row);
  }
  for (int column = 0; column < lines; ++column) {
    auto next = static_cast<std::uint32_t>(cut.crossings.size());
    search.Along({grid.Column(column), -slice.extent}, slice.v);
    for (; next < cut.crossings.size(); ++next) joining.VisitColumn(next, column);
  }
  joining.Run();
  return cut;
}

}  // namespace ray
