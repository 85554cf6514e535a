#include "R3/Polygon.h"

#include <algorithm>

#include "R2/Point.h"
#include "R3/Vector.h"

namespace R3 {
namespace {

/// The maximum number of corners that ear clipping examines per corner of the polygon, so that reading a file takes
/// linear time. No polygon of n = 5,000 corners or fewer needs more than 2.5 n: n to find the first ears, n / 2 on
/// average for each of the two neighbors of an ear, and at most n / 2 to find the next one. 15 us per corner on an AMD
/// EPYC.
constexpr std::size_t most_looks_a_corner = 12'500;

/// Newell's normal. `cancels` is true if it is shorter than one of its terms, since the polygon turns about equally in
/// both directions.
struct Newell {
  Vector normal;
  bool cancels = false;
};

Newell NewellOf(std::span<const Point> polygon) {
  Vector normal;
  double largest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const Vector term = Cross(a, b);
    normal = normal + term;
    largest = std::max(largest, MaxComponent(Abs(term)));
  }
  return {normal, MaxComponent(Abs(normal)) < largest};
}

/// Returns the polygon projected along the axis of its normal's largest component, turning counter-clockwise.
std::vector<R2::Point> Flattened(std::span<const Point> polygon, const Vector& normal) {
  const int axis = MaxAxis(normal);
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  std::vector<R2::Point> flat;
  flat.reserve(polygon.size());
  for (const Point& p : polygon) flat.push_back({p[x], p[y]});
  return flat;
}

/// Returns twice the area of a triangle, positive if it turns counter-clockwise. If rounding decides the sign, either
/// cut of the polygon is equally good.
double Turn(const R2::Point& a, const R2::Point& b, const R2::Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool IsSamePlace(const R2::Point& a, const R2::Point& b) { return a.x == b.x && a.y == b.y; }

/// Returns true if the whole polygon is visible from its first corner: no triangle of the fan is flipped.
bool FanFits(std::span<const R2::Point> polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (Turn(polygon[0], polygon[i - 1], polygon[i]) < 0) return false;
  return true;
}

/// Ear clipping, one corner at a time. The set of ears is kept up to date: a cut changes only the two neighbors.
class EarClipping {
 public:
  explicit EarClipping(std::span<const R2::Point> polygon) : polygon_(polygon) {
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    is_ear_.resize(n, false);
  }

  /// Returns the cuts; std::nullopt if they would take too long.
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
  /// Returns the first ear from this corner on; the corner itself if no ear is left.
  std::uint32_t NextEar(std::uint32_t corner, std::size_t left) {
    std::uint32_t ear = corner;
    for (std::size_t i = 0; i < left && !is_ear_[ear]; ++i) ear = after_[ear], ++looks_;
    return ear;
  }

  std::uint32_t Remove(std::uint32_t corner) {
    const std::uint32_t previous = before_[corner], next = after_[corner];
    after_[previous] = next;
    before_[next] = previous;
    is_ear_[previous] = IsEar(previous);
    is_ear_[next] = IsEar(next);
    return next;
  }

  bool IsEar(std::uint32_t corner) {
    const R2::Point &a = polygon_[before_[corner]], &b = polygon_[corner], &c = polygon_[after_[corner]];
    if (!(Turn(a, b, c) > 0)) return false;
    const R2::Point low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
        high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    for (std::uint32_t i = after_[after_[corner]]; i != before_[corner]; i = after_[i], ++looks_) {
      const R2::Point& p = polygon_[i];
      const bool is_near = p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
      if (is_near && IsIn(p, a, b, c)) return false;
    }
    return true;
  }

  /// Returns true if a point lies in the triangle and does not coincide with one of its corners.
  static bool IsIn(const R2::Point& p, const R2::Point& a, const R2::Point& b, const R2::Point& c) {
    return Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0 && !IsSamePlace(p, a) && !IsSamePlace(p, b) &&
           !IsSamePlace(p, c);
  }

  std::span<const R2::Point> polygon_;
  std::vector<std::uint32_t> before_, after_;
  std::vector<bool> is_ear_;
  std::size_t looks_ = 0;
};

double Extent(std::span<const Point> polygon) {
  double extent = 0;
  for (const Point& p : polygon) extent = std::max(extent, Length(p - polygon[0]));
  return extent;
}

/// The tolerance for corners that were typed by hand and rounded to a digit or two: those of scenes/solids.yaml are off
/// by a third of this.
constexpr double flatness = 0.05;  // of the polygon's extent

/// Returns Newell's normal. If the polygon crosses itself and turns about equally in both directions, returns the
/// normal of its largest triangle from the first corner.
Vector NormalOfAny(std::span<const Point> polygon) {
  // The minimum area as a share of the square around the polygon. Thinner slivers use the normal of their largest
  // triangle, which is theirs as well.
  constexpr double least = 1e-3;
  Vector normal = NewellOf(polygon).normal;
  const double extent = Extent(polygon);
  if (Length(normal) > least * extent * extent) return normal;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector of_triangle = Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    if (Length(of_triangle) > Length(normal)) normal = of_triangle;
  }
  return normal;
}

bool IsFlat(std::span<const Point> polygon, const Vector& normal) {
  if (!(Length(normal) > 0)) return true;  // a line, which is not a surface anyway
  const auto distance = [&](const Point& p) { return Dot(p - polygon[0], normal) / Length(normal); };
  double low = 0, high = 0;
  for (const Point& p : polygon) {
    low = std::min(low, distance(p));
    high = std::max(high, distance(p));
  }
  return high - low <= flatness * Extent(polygon);
}

/// Returns true if the sides a-b and c-d cross by more than `least` of twice an area: sides may touch.
bool DoCross(const R2::Point& a, const R2::Point& b, const R2::Point& c, const R2::Point& d, double least) {
  const auto on_both_sides = [&](double s, double t) { return std::min(s, t) < -least && std::max(s, t) > least; };
  return on_both_sides(Turn(a, b, c), Turn(a, b, d)) && on_both_sides(Turn(c, d, a), Turn(c, d, b));
}

/// A point where two sides cross, as seen from each of them.
struct Meeting {
  SideCrossing on_first, on_second;
};

/// Returns up to `most` points where sides cross. Takes quadratic time, so the result is empty for polygons with more
/// than max_concave_corners.
std::vector<Meeting> MeetingsOfSides(std::span<const Point> polygon, const Vector& normal, std::size_t most) {
  const std::size_t n = polygon.size();
  std::vector<Meeting> meetings;
  if (n > max_concave_corners) return meetings;
  // The largest turn of three corners on a line that were rounded to seven digits, as a share of the square around the
  // polygon.
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

/// Returns the way around a polygon past its corners and, twice each, its crossings.
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

/// Returns the parts of a flat polygon that crosses itself, as loops of its corners and crossings; empty for any other
/// polygon.
std::vector<std::vector<std::uint32_t>> LoopsOf(std::span<const Point> polygon, std::span<const Meeting> meetings) {
  // When the way reaches a crossing for the second time, it has closed a loop, which is removed from it.
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

/// Cuts a polygon that crosses itself; std::nullopt if it does not, does so too often, or is not flat.
std::optional<CutPolygon> CutWhereSidesCross(std::span<const Point> polygon) {
  const Vector normal = NormalOfAny(polygon);
  if (!IsFlat(polygon, normal)) return {};
  const std::size_t too_many = polygon.size() + 1;  // limits the memory of a mesh by the size of its file
  const std::vector<Meeting> meetings = MeetingsOfSides(polygon, normal, too_many);
  if (meetings.empty() || meetings.size() == too_many) return {};
  std::vector<Point> places(polygon.begin(), polygon.end());
  CutPolygon cut;
  for (const Meeting& meeting : meetings) {
    const auto& [side, share] = cut.crossings.emplace_back(meeting.on_first);
    places.push_back(polygon[side] + share * (polygon[(side + 1) % polygon.size()] - polygon[side]));
  }
  for (const auto& loop : LoopsOf(polygon, meetings)) {
    std::vector<Point> corners;
    for (const std::uint32_t i : loop) corners.push_back(places[i]);
    for (const auto& t : Triangulate(corners).value_or(Fan(corners.size())))
      cut.cuts.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  return cut;
}

}  // namespace

const char* FaultOfPolygon(std::span<const Point> polygon) {
  if (polygon.size() == 3) return nullptr;
  const Vector normal = NormalOfAny(polygon);
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

std::optional<Cuts> Triangulate(std::span<const Point> polygon) {
  if (polygon.size() == 3) return Fan(3);
  const std::vector<R2::Point> flat = Flattened(polygon, NewellOf(polygon).normal);
  if (FanFits(flat)) return Fan(polygon.size());
  return EarClipping(flat).CutAll();
}

std::optional<CutPolygon> CutApart(std::span<const Point> polygon) {
  if (polygon.size() == 3) return CutPolygon{Fan(3)};
  const Newell newell = NewellOf(polygon);
  const std::vector<R2::Point> flat = Flattened(polygon, newell.normal);
  const bool is_fan = FanFits(flat);
  // If the terms cancel, the polygon may be seen edge-on, and a fan decides nothing.
  if (!is_fan || newell.cancels)
    if (auto cut = CutWhereSidesCross(polygon)) return cut;
  if (is_fan) return CutPolygon{Fan(polygon.size())};
  if (auto cuts = EarClipping(flat).CutAll()) return CutPolygon{std::move(*cuts)};
  return {};
}

}  // namespace R3
