#include "source/parse/meshes/Polygon.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "R2/Point.h"
#include "R3/Vector.h"

namespace ray {
namespace {

/// Ear clipping ends after so many looks at nodes and corners, so that reading a file takes linear time. Combs, stars
/// and spirals of 5,000 corners need 60 to 390, and no polygon of up to max_concave_corners more than 1200: at most 1.3
/// n for each of the 3 n corners that are tried, and n / 2 to find the next ear.
constexpr std::size_t most_looks_a_corner = 2048;

/// Newell's normal, and whether it is shorter than one of its terms, since the polygon turns about as much either way.
struct Newell {
  R3::Vector normal;
  bool cancels = false;
};

Newell NewellOf(std::span<const R3::Point> polygon) {
  R3::Vector normal;
  double largest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const R3::Vector a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const R3::Vector term = Cross(a, b);
    normal = normal + term;
    largest = std::max(largest, MaxComponent(Abs(term)));
  }
  return {normal, MaxComponent(Abs(normal)) < largest};
}

/// The polygon as seen along the axis of its normal's largest component, turning counter-clockwise.
std::vector<R2::Point> Flattened(std::span<const R3::Point> polygon, const R3::Vector& normal) {
  const int axis = MaxAxis(normal);
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  std::vector<R2::Point> flat;
  flat.reserve(polygon.size());
  for (const R3::Point& p : polygon) flat.push_back({p[x], p[y]});
  return flat;
}

/// Twice the area of a triangle, positive when it turns counter-clockwise. Where rounding decides the sign, either cut
/// of the polygon is as good.
double Turn(const R2::Point& a, const R2::Point& b, const R2::Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool IsSamePlace(const R2::Point& a, const R2::Point& b) { return a.x == b.x && a.y == b.y; }

/// Whether the whole polygon is seen from its first corner: no triangle of the fan is turned over.
bool FanFits(std::span<const R2::Point> polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (Turn(polygon[0], polygon[i - 1], polygon[i]) < 0) return false;
  return true;
}

/// The corners of a polygon by where they are, halved again and again, to find those in a triangle.
class CornerTree {
 public:
  explicit CornerTree(std::span<const R2::Point> polygon) : polygon_(polygon), leaf_of_(polygon.size()) {
    sorted_.resize(polygon.size());
    std::iota(sorted_.begin(), sorted_.end(), 0u);
    nodes_.emplace_back();
    Build(0, 0, static_cast<std::uint32_t>(polygon.size()));
  }

  /// Whether one of the corners that were not removed lies in a triangle, and not in the place of one of its corners.
  /// Adds how many nodes and corners were looked at.
  bool AnyIn(const std::array<R2::Point, 3>& triangle, std::size_t& looks) const {
    return AnyIn(nodes_[0], triangle, looks);
  }

  void Remove(std::uint32_t corner) {
    for (std::uint32_t node = leaf_of_[corner];; node = nodes_[node].parent) {
      --nodes_[node].left;
      if (node == 0) break;
    }
    leaf_of_[corner] = removed;
  }

 private:
  static constexpr std::uint32_t removed = 0xFFFFFFFF, most_in_leaf = 8;

  struct Node {
    R2::Point low, high;
    std::uint32_t first = 0, last = 0;  // of a leaf: indices into `sorted_`
    std::uint32_t children = 0;         // the first of two; 0: a leaf
    std::uint32_t parent = 0, left = 0;
  };

  void Build(std::uint32_t number, std::uint32_t first, std::uint32_t last) {
    Node node = nodes_[number];  // which move as they become more
    node.low = node.high = polygon_[sorted_[first]];
    for (std::uint32_t i = first; i < last; ++i) {
      const R2::Point& p = polygon_[sorted_[i]];
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
    }
    node.first = first, node.last = last, node.left = last - first;
    const bool is_leaf = last - first <= most_in_leaf;
    node.children = is_leaf ? 0 : static_cast<std::uint32_t>(nodes_.size());
    nodes_[number] = node;
    if (is_leaf) {
      for (std::uint32_t i = first; i < last; ++i) leaf_of_[sorted_[i]] = number;
      return;
    }
    const std::uint32_t middle = first + (last - first) / 2;
    Halve(first, middle, last, node.high.x - node.low.x > node.high.y - node.low.y ? &R2::Point::x : &R2::Point::y);
    nodes_.resize(nodes_.size() + 2);
    nodes_[node.children].parent = nodes_[node.children + 1].parent = number;
    Build(node.children, first, middle);
    Build(node.children + 1, middle, last);
  }

  void Halve(std::uint32_t first, std::uint32_t middle, std::uint32_t last, double R2::Point::*axis) {
    const auto part = std::span(sorted_).subspan(first, last - first);
    std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(middle - first), {},
                             [&](std::uint32_t i) { return polygon_[i].*axis; });
  }

  bool AnyIn(const Node& node, const std::array<R2::Point, 3>& triangle, std::size_t& looks) const {
    ++looks;
    if (node.left == 0 || IsOutside(node, triangle)) return false;
    if (node.children != 0)
      return AnyIn(nodes_[node.children], triangle, looks) || AnyIn(nodes_[node.children + 1], triangle, looks);
    looks += node.last - node.first;
    const auto corners = std::span(sorted_).subspan(node.first, node.last - node.first);
    return std::ranges::any_of(corners,
                               [&](std::uint32_t i) { return leaf_of_[i] != removed && IsIn(polygon_[i], triangle); });
  }

  static bool IsIn(const R2::Point& p, const std::array<R2::Point, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    return Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0 && !IsSamePlace(p, a) && !IsSamePlace(p, b) &&
           !IsSamePlace(p, c);
  }

  /// Whether a side of the triangle has the whole box behind it. Turn, rounded as it is, only grows or only falls with
  /// either coordinate of its last point, so the corner of the box that lies most to the front speaks for all within.
  static bool IsOutside(const Node& box, const std::array<R2::Point, 3>& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const R2::Point &a = triangle[i], &b = triangle[(i + 1) % 3];
      const R2::Point most{b.y > a.y ? box.low.x : box.high.x, b.x > a.x ? box.high.y : box.low.y};
      if (Turn(a, b, most) < 0) return true;
    }
    return false;
  }

  std::span<const R2::Point> polygon_;
  std::vector<std::uint32_t> sorted_, leaf_of_;
  std::vector<Node> nodes_;
};

/// Cuts off one corner after the other. Which corners are ears is kept up to date: cutting changes it for the two
/// neighbors only.
class EarClipping {
 public:
  explicit EarClipping(std::span<const R2::Point> polygon) : polygon_(polygon), tree_(polygon) {
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    is_ear_.resize(n, false);
  }

  /// Nothing where it would take too long.
  std::optional<Cuts> CutAll() {
    const std::size_t most_looks = most_looks_a_corner * polygon_.size();
    for (std::uint32_t i = 0; i < polygon_.size() && looks_ <= most_looks; ++i) is_ear_[i] = IsEar(i);
    Cuts cuts;
    std::uint32_t corner = 0;
    for (std::size_t left = polygon_.size(); left > 3; --left) {
      if (looks_ > most_looks) return {};
      corner = NextEar(corner, left);
      cuts.push_back({before_[corner], corner, after_[corner]});
      corner = Remove(corner);
    }
    cuts.push_back({before_[corner], corner, after_[corner]});
    return cuts;
  }

 private:
  /// The first ear from here on; the corner itself if none is left.
  std::uint32_t NextEar(std::uint32_t corner, std::size_t left) {
    std::uint32_t ear = corner;
    for (std::size_t i = 0; i < left && !is_ear_[ear]; ++i) ear = after_[ear], ++looks_;
    return ear;
  }

  std::uint32_t Remove(std::uint32_t corner) {
    const std::uint32_t previous = before_[corner], next = after_[corner];
    tree_.Remove(corner);
    after_[previous] = next;
    before_[next] = previous;
    is_ear_[previous] = IsEar(previous);
    is_ear_[next] = IsEar(next);
    return next;
  }

  bool IsEar(std::uint32_t corner) {
    const R2::Point &a = polygon_[before_[corner]], &b = polygon_[corner], &c = polygon_[after_[corner]];
    return Turn(a, b, c) > 0 && !tree_.AnyIn({a, b, c}, looks_);
  }

  std::span<const R2::Point> polygon_;
  CornerTree tree_;
  std::vector<std::uint32_t> before_, after_;
  std::vector<bool> is_ear_;
  std::size_t looks_ = 0;
};

double Extent(std::span<const R3::Point> polygon) {
  double extent = 0;
  for (const R3::Point& p : polygon) extent = std::max(extent, Length(p - polygon[0]));
  return extent;
}

/// Corners typed by hand, rounded to a digit or two, are off by less: those of scenes/solids.yaml by a third of this.
constexpr double flatness = 0.05;  // of the polygon's extent

/// Newell's normal, but where the polygon crosses itself and turns about as much either way: then that of its largest
/// triangle from the first corner.
R3::Vector NormalOfAny(std::span<const R3::Point> polygon) {
  // Share of the area of the square around the polygon. Slivers of less take the normal of their largest triangle,
  // which is theirs as well.
  constexpr double least = 1e-3;
  R3::Vector normal = NewellOf(polygon).normal;
  const double extent = Extent(polygon);
  if (Length(normal) > least * extent * extent) return normal;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const R3::Vector of_triangle = Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    if (Length(of_triangle) > Length(normal)) normal = of_triangle;
  }
  return normal;
}

bool IsFlat(std::span<const R3::Point> polygon, const R3::Vector& normal) {
  if (!(Length(normal) > 0)) return true;  // a line, which is no surface either
  const auto distance = [&](const R3::Point& p) { return Dot(p - polygon[0], normal) / Length(normal); };
  double low = 0, high = 0;
  for (const R3::Point& p : polygon) {
    low = std::min(low, distance(p));
    high = std::max(high, distance(p));
  }
  return high - low <= flatness * Extent(polygon);
}

/// Whether the sides a-b and c-d cross, by more than `least` of twice an area: sides may touch.
bool DoCross(const R2::Point& a, const R2::Point& b, const R2::Point& c, const R2::Point& d, double least) {
  const auto on_both_sides = [&](double s, double t) { return std::min(s, t) < -least && std::max(s, t) > least; };
  return on_both_sides(Turn(a, b, c), Turn(a, b, d)) && on_both_sides(Turn(c, d, a), Turn(c, d, b));
}

/// A place where two sides cross, as each of them passes it.
struct Meeting {
  SideCrossing on_first, on_second;
};

/// Finds up to so many places where sides cross. Takes quadratic time, so nothing is found of polygons with more than
/// max_concave_corners.
std::vector<Meeting> MeetingsOfSides(std::span<const R3::Point> polygon, const R3::Vector& normal, std::size_t most) {
  const std::size_t n = polygon.size();
  std::vector<Meeting> meetings;
  if (n > max_concave_corners) return meetings;
  // Corners that were rounded to seven digits may turn by such a share of the square around them where they lie on a
  // line.
  constexpr double rounding = 1e-6;
  const double extent = Extent(polygon), least = rounding * extent * extent;
  const std::vector<R2::Point> flat = Flattened(polygon, normal);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      const R2::Point &a = flat[i], &b = flat[i + 1], &c = flat[j], &d = flat[(j + 1) % n];
      if (!DoCross(a, b, c, d, least)) continue;
      const double to_a = Turn(c, d, a), to_b = Turn(c, d, b), to_c = Turn(a, b, c), to_d = Turn(a, b, d);
      meetings.push_back({{static_cast<std::uint32_t>(i), to_a / (to_a - to_b)},
                          {static_cast<std::uint32_t>(j), to_c / (to_c - to_d)}});
      if (meetings.size() == most) return meetings;
    }
  return meetings;
}

/// The way around a polygon past its corners and, twice each, its crossings.
std::vector<std::uint32_t> WayAround(std::size_t corners, std::span<const Meeting> meetings) {
  std::vector<std::vector<std::pair<double, std::uint32_t>>> on_side(corners);
  for (std::uint32_t i = 0; i < meetings.size(); ++i)
    for (const SideCrossing& crossing : {meetings[i].on_first, meetings[i].on_second})
      on_side[crossing.side].push_back({crossing.share, static_cast<std::uint32_t>(corners) + i});
  std::vector<std::uint32_t> way;
  for (std::uint32_t i = 0; i < corners; ++i) {
    way.push_back(i);
    std::ranges::sort(on_side[i]);
    for (const auto& crossing : on_side[i]) way.push_back(crossing.second);
  }
  return way;
}

/// The parts of a flat polygon that crosses itself, as loops of its corners and crossings; none of any other polygon.
std::vector<std::vector<std::uint32_t>> LoopsOf(std::span<const R3::Point> polygon, std::span<const Meeting> meetings) {
  // Where the way comes to a crossing for the second time it has closed a loop, which is taken off it.
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> open;
  for (const std::uint32_t place : WayAround(polygon.size(), meetings)) {
    const auto before = std::ranges::find(open, place);
    if (before != open.end()) {
      loops.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(place);
  }
  loops.push_back(std::move(open));
  std::erase_if(loops, [](const auto& loop) { return loop.size() < 3; });
  return loops;
}

/// Cuts a polygon that crosses itself; nothing for one that does not, does so too often, or is not flat.
std::optional<CutPolygon> CutWhereSidesCross(std::span<const R3::Point> polygon) {
  const R3::Vector normal = NormalOfAny(polygon);
  if (!IsFlat(polygon, normal)) return {};
  const std::size_t too_many = polygon.size() + 1;  // so that a mesh takes no more memory than its file promises
  const std::vector<Meeting> meetings = MeetingsOfSides(polygon, normal, too_many);
  if (meetings.empty() || meetings.size() == too_many) return {};
  std::vector<R3::Point> places(polygon.begin(), polygon.end());
  CutPolygon cut;
  for (const Meeting& meeting : meetings) {
    const auto& [side, share] = cut.crossings.emplace_back(meeting.on_first);
    places.push_back(polygon[side] + share * (polygon[(side + 1) % polygon.size()] - polygon[side]));
  }
  for (const auto& loop : LoopsOf(polygon, meetings)) {
    std::vector<R3::Point> corners;
    for (const std::uint32_t i : loop) corners.push_back(places[i]);
    for (const auto& t : Triangulate(corners).value_or(Fan(corners.size())))
      cut.cuts.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  return cut;
}

}  // namespace

const char* FaultOfPolygon(std::span<const R3::Point> polygon) {
  if (polygon.size() == 3) return nullptr;
  const R3::Vector normal = NormalOfAny(polygon);
  if (!IsFlat(polygon, normal)) return "has corners that are not in one plane";
  return MeetingsOfSides(polygon, normal, 1).empty() ? nullptr : "has sides that cross";
}

Cuts Fan(std::size_t corners) {
  Cuts fan;
  fan.reserve(corners - 2);
  for (std::uint32_t i = 2; i < corners; ++i) fan.push_back({0, i - 1, i});
  return fan;
}

std::vector<R2::Point> QuadUvs() { return {{0, 0}, {1, 0}, {1, 1}, {0, 1}}; }

std::optional<Cuts> Triangulate(std::span<const R3::Point> polygon) {
  if (polygon.size() == 3) return Fan(3);
  const std::vector<R2::Point> flat = Flattened(polygon, NewellOf(polygon).normal);
  if (FanFits(flat)) return Fan(polygon.size());
  return EarClipping(flat).CutAll();
}

std::optional<CutPolygon> CutApart(std::span<const R3::Point> polygon) {
  if (polygon.size() == 3) return CutPolygon{Fan(3)};
  const Newell newell = NewellOf(polygon);
  const std::vector<R2::Point> flat = Flattened(polygon, newell.normal);
  const bool is_fan = FanFits(flat);
  // Where the terms cancel, it may be seen edge-on, and a fan tells nothing.
  if (!is_fan || newell.cancels)
    if (auto cut = CutWhereSidesCross(polygon)) return cut;
  if (is_fan) return CutPolygon{Fan(polygon.size())};
  if (auto cuts = EarClipping(flat).CutAll()) return CutPolygon{std::move(*cuts)};
  return {};
}

}  // namespace ray
