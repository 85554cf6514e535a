#include "R3/ByRays.h"

#include <cstdint>

#include "R3/Warp.h"

namespace R3 {
namespace {

Vector UnitVector(int axis) { return {axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0}; }

/// Returns the next crossing with any element, and moves the start of the ray there.
std::optional<Intersection> Next(const Shape& shape, Ray& ray) {
  std::optional<Intersection> next;
  Ray nearer = ray;
  for (int i = 0; i < shape.Elements(); ++i)
    if (const auto hit = shape.Intersect(nearer, i)) {
      nearer.t_max = hit->t;
      next = shape.At(ray, *hit, i);
    }
  ray.t_min = nearer.t_max;
  return next;
}

/// Returns the crossing nearest to `p` on the line from p + reach to p - reach, among those that face its start.
std::optional<Intersection> NearestFacing(const Shape& shape, const Point& p, const Vector& reach) {
  Ray ray{p + reach, -reach, 0, 2};
  std::optional<Intersection> nearest;
  while (const auto at = Next(shape, ray))
    if (Dot(at->normal, reach) > 0 && (!nearest || Length(at->position - p) < Length(nearest->position - p)))
      nearest = at;
  return nearest;
}

/// Adds a triangle with the normals and texture coordinates of the surface slightly inside its corners, which differ
/// from those at the corner if that is on an edge or a seam. Periodic coordinates continue beyond 0 and 1.
void AddTriangle(MeshData& data, const Shape& shape, const std::array<Point, 3>& corners, double reach) {
  const Vector front = Unit(Cross(corners[1] - corners[0], corners[2] - corners[0]));
  if (front == Vector{}) return;
  const auto beneath = [&](const Point& p, const Intersection& otherwise) {
    constexpr double least_cosine = 0.5;  // surfaces turned further away lie beyond an edge
    const auto at = NearestFacing(shape, p, reach * front);
    return at && Dot(at->normal, front) > least_cosine ? *at : otherwise;
  };
  const Point middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3;
  Intersection flat = NearestFacing(shape, middle, reach * front).value_or(Intersection{});
  flat.shading_normal = AsNormal(front);
  const Intersection whole = beneath(middle, flat);
  // A corner may lie on an edge between two faces, so the normal is taken a millionth of the way inside: far more than
  // rounding, far less than is visible.
  constexpr double inward = 1e-6;
  const auto first = static_cast<std::uint32_t>(data.positions.size());
  data.triangles.push_back({first, first + 1, first + 2});
  for (const Point& corner : corners) {
    const Intersection at = beneath(corner + inward * (middle - corner), whole);
    data.positions.push_back(corner);
    data.normals.push_back(at.shading_normal);
    data.uvs.push_back({at.uv.x - std::round(at.uv.x - whole.uv.x), at.uv.y - std::round(at.uv.y - whole.uv.y)});
  }
}

/// A grid of nearly cubic cells around a shape. It is off center, so that it shares no symmetry of the shape and no ray
/// along its edges lies in a face or touches a turn.
class Grid {
 public:
  using Index = std::array<int, 3>;

  Grid(const Box& box, double cell) : low_(box.low) {
    for (int axis = 0; axis < 3; ++axis) {
      const double size = box.Size()[axis];
      constexpr double least = 3;
      const double cells = std::max(least, std::ceil(size / cell));
      cells_[static_cast<std::size_t>(axis)] = static_cast<int>(cells) + 1;
      cell_[static_cast<std::size_t>(axis)] = size / cells;
      constexpr double before = 0.37;  // share of the extra cell that precedes the shape
      low_ = low_ - before * Edge(axis);
    }
  }

  int Cells(int axis) const { return cells_[static_cast<std::size_t>(axis)]; }
  /// Returns the vector from a node to the next along an axis.
  Vector Edge(int axis) const { return cell_[static_cast<std::size_t>(axis)] * UnitVector(axis); }
  double Diagonal() const { return Length(Edge(0) + Edge(1) + Edge(2)); }
  Point Node(const Index& i) const { return low_ + (i[0] * Edge(0) + i[1] * Edge(1) + i[2] * Edge(2)); }
  std::size_t Number(const Index& i) const {
    return static_cast<std::size_t>((i[2] * (Cells(1) + 1) + i[1]) * (Cells(0) + 1) + i[0]);
  }
  std::size_t Nodes() const { return Number(cells_) + 1; }

  /// Calls visit(lowest node) for all cells.
  template <typename Visit>
  void ForEachCell(const Visit& visit) const {
    for (int z = 0; z < Cells(2); ++z)
      for (int y = 0; y < Cells(1); ++y)
        for (int x = 0; x < Cells(0); ++x) visit(Index{x, y, z});
  }

 private:
  Point low_;
  Index cells_{};
  std::array<double, 3> cell_{};
};

Grid::Index Moved(Grid::Index i, int axis, int by) {
  i[static_cast<std::size_t>(axis)] += by;
  return i;
}

class SurfaceNet {
 public:
  SurfaceNet(const Shape& shape, double cell)
      : shape_(shape), grid_(Bounds(shape), cell), is_inside_(grid_.Nodes()), corners_(grid_.Nodes()) {}

  MeshData Build() {
    for (int z = 0; z <= grid_.Cells(2); ++z)
      for (int y = 0; y <= grid_.Cells(1); ++y) MarkInside({0, y, z});
    grid_.ForEachCell([&](const Grid::Index& i) { corners_[grid_.Number(i)] = CornerIn(i); });
    MeshData data;
    grid_.ForEachCell([&](const Grid::Index& i) {
      for (int axis = 0; axis < 3; ++axis) AddAcross(data, i, axis);
    });
    return data;
  }

 private:
  bool IsInside(const Grid::Index& i) const { return is_inside_[grid_.Number(i)]; }

  /// Marks the nodes on the line from `start` along x that lie between an entry and an exit.
  void MarkInside(const Grid::Index& start) {
    Ray ray{grid_.Node(start), grid_.Edge(0), 0, static_cast<double>(grid_.Cells(0))};
    std::optional<double> entered;
    while (const auto at = Next(shape_, ray)) {
      const bool enters = Dot(at->normal, ray.direction) < 0;
      if (entered && !enters)
        for (int x = static_cast<int>(*entered) + 1; x < ray.t_min; ++x)
          is_inside_[grid_.Number({x, start[1], start[2]})] = true;
      entered = enters ? std::optional(ray.t_min) : std::nullopt;
    }
  }

  /// Returns a point of the surface near the middle of its part in a cell.
  Point CornerIn(const Grid::Index& cell) const {
    std::vector<Intersection> crossings;
    Vector middle, normal;
    for (int edge = 0; edge < 12; ++edge) {
      const int axis = edge / 4;
      const auto start = Moved(Moved(cell, (axis + 1) % 3, edge & 1), (axis + 2) % 3, edge >> 1 & 1);
      const auto end = Moved(start, axis, 1);
      if (IsInside(start) == IsInside(end)) continue;
      const auto &outside = IsInside(start) ? end : start, &inside = IsInside(start) ? start : end;
      Ray ray{grid_.Node(outside), grid_.Node(inside) - grid_.Node(outside), 0, 1};
      const auto at = Next(shape_, ray);
      if (!at) continue;
      crossings.push_back(*at);
      middle = middle + FromOrigin(at->position);
      normal = normal + AsVector(at->normal);
    }
    if (crossings.empty()) return grid_.Node(cell);
    const Point p = Point{} + middle / static_cast<double>(crossings.size());
    const auto at = NearestFacing(shape_, p, grid_.Diagonal() * Unit(normal));
    return at ? at->position : crossings[0].position;
  }

  /// Adds two triangles between the four cells around an edge of the grid that the surface crosses.
  void AddAcross(MeshData& data, const Grid::Index& start, int axis) const {
    const bool leaves = IsInside(start);
    if (leaves == IsInside(Moved(start, axis, 1))) return;
    const int right = (axis + (leaves ? 1 : 2)) % 3, up = (axis + (leaves ? 2 : 1)) % 3;
    const auto corner = [&](int r, int u) { return corners_[grid_.Number(Moved(Moved(start, right, r), up, u))]; };
    const Point a = corner(-1, -1), b = corner(0, -1), c = corner(0, 0), d = corner(-1, 0);
    const bool cut_from_a = Length(c - a) < Length(d - b);
    AddTriangle(data, shape_, {a, b, cut_from_a ? c : d}, grid_.Diagonal());
    AddTriangle(data, shape_, {cut_from_a ? a : b, c, d}, grid_.Diagonal());
  }

  const Shape& shape_;
  Grid grid_;
  std::vector<bool> is_inside_;  // of each node
  std::vector<Point> corners_;   // of each cell, by its lowest node
};

/// The views of a sheet from far away on both sides along an axis, clipped at its rim; the second view adds only what
/// the first does not see.
class SideViews {
 public:
  SideViews(const Shape& shape, double cell, int axis)
      : shape_(shape),
        grid_(Bounds(shape), cell),
        right_((axis + 1) % 3),
        up_((axis + 2) % 3),
        size_(Bounds(shape).Radius()),
        to_eye_(size_ * UnitVector(axis)) {}

  void AddTo(MeshData& data) const {
    for (int u = 0; u < grid_.Cells(up_); ++u)
      for (int r = 0; r < grid_.Cells(right_); ++r) {
        const auto front = Outline(r, u, 1), back = Outline(r, u, -1);
        AddPolygon(data, front, 1);
        constexpr double same = 1e-9;  // relative to the size: a million times rounding, a millionth of a pixel of 1000
        if (!std::equal(front.begin(), front.end(), back.begin(), back.end(),
                        [&](const Point& a, const Point& b) { return Length(a - b) <= same * size_; }))
          AddPolygon(data, {back.rbegin(), back.rend()}, -1);
      }
  }

 private:
  /// Returns the first hit on the line through a point given in cells.
  std::optional<Point> Seen(const R2::Point& place, double side) const {
    const Point p = grid_.Node({0, 0, 0}) + (place.x * grid_.Edge(right_) + place.y * grid_.Edge(up_));
    Ray ray{p + 4 * side * to_eye_, -side * to_eye_};
    const auto at = Next(shape_, ray);
    return at ? std::optional(at->position) : std::nullopt;
  }

  /// Returns the last visible point on the way from a visible one to one that is not.
  Point Rim(R2::Point seen, R2::Point unseen, double side) const {
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
      const R2::Point middle{(seen.x + unseen.x) / 2, (seen.y + unseen.y) / 2};
      (Seen(middle, side) ? seen : unseen) = middle;
    }
    return *Seen(seen, side);
  }

  /// Returns the visible outline within a cell, counterclockwise for the eye at the side +1.
  std::vector<Point> Outline(int r, int u, double side) const {
    const auto place = [&](int i) {
      return R2::Point{r + static_cast<double>(i % 4 == 1 || i % 4 == 2), u + static_cast<double>(i % 4 >= 2)};
    };
    std::vector<Point> outline;
    for (int i = 0; i < 4; ++i) {
      const auto here = Seen(place(i), side), next = Seen(place(i + 1), side);
      if (here) outline.push_back(*here);
      if (here && !next) outline.push_back(Rim(place(i), place(i + 1), side));
      if (!here && next) outline.push_back(Rim(place(i + 1), place(i), side));
    }
    return outline;
  }

  /// Adds a polygon unless it is steep. Another axis sees steep parts better, including those that connect a sheet to
  /// one behind it.
  void AddPolygon(MeshData& data, const std::vector<Point>& corners, double side) const {
    constexpr double steep = 0.5;  // below 1 / sqrt 3, so that some eye sees every part well
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Point &a = corners[0], &b = corners[i - 1], &c = corners[i];
      const Vector front = Unit(Cross(b - a, c - a));
      if (!(side * Dot(front, to_eye_) >= steep * size_)) continue;
      const auto at = NearestFacing(shape_, a + ((b - a) + (c - a)) / 3, grid_.Diagonal() * front);
      AddTriangle(data, shape_, at ? std::array{a, b, c} : std::array{a, c, b}, grid_.Diagonal());
    }
  }

  const Shape& shape_;
  Grid grid_;
  int right_, up_;
  double size_;
  Vector to_eye_;
};

}  // namespace

MeshData TessellateByRays(const Shape& shape, int triangles) {
  // A closed surface that fills its box takes ten to thirteen triangles per three cells of the box's sides; a sheet
  // that all eyes see takes no more.
  const Vector size = Bounds(shape).Size();
  const double cell = std::sqrt(4.4 * (size.x * size.y + size.y * size.z + size.z * size.x) / triangles);
  if (shape.IsSolid()) return SurfaceNet(shape, cell).Build();
  MeshData data;
  for (int axis = 0; axis < 3; ++axis) SideViews(shape, cell, axis).AddTo(data);
  return data;
}

namespace {

constexpr double step_share = 0x1p-15;  // relative to the size of the shape

/// Returns the difference of two nearby texture coordinates, across the seam if that is shorter.
double OverSeam(double difference) { return difference - std::round(difference); }

}  // namespace

UvTangents UvTangentsByRays(const Shape& shape, const Ray& ray, const Hit& hit, int element) {
  const Intersection at = shape.At(ray, hit, element);
  const Vector n = AsVector(at.normal);
  // Unbounded shapes repeat their texture every unit.
  const double step = step_share * (shape.IsBounded() ? shape.Bounds(element).Radius() : 1);
  const auto uv_at = [&](const Vector& aside) -> std::optional<R2::Point> {
    const Ray down{at.position + aside + step * n, -n, 0, 2 * step, ray.time};
    const auto found = shape.Intersect(down, element);
    if (!found || found->part != hit.part) return {};
    return shape.At(down, *found, element).uv;
  };
  const auto gain_over = [&](const Vector& aside) -> R2::Vector {
    const auto ahead = uv_at(aside), behind = uv_at(-aside);
    if (!ahead && !behind) return {};
    const R2::Vector gain = ahead.value_or(at.uv) - behind.value_or(at.uv);
    return (ahead && behind ? 0.5 : 1) * R2::Vector{OverSeam(gain.x), OverSeam(gain.y)};
  };
  const Tangents tangents = TangentsOf(n);
  const Vector first = step * tangents.first, second = step * tangents.second;
  return {first, second, gain_over(first), gain_over(second)};
}

}  // namespace R3
