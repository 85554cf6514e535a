#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "R3/Numeric.h"

/// The intersections of a line with a bicubic patch.
namespace R3::patch {

/// Values at the 16 control points, by row: those of one row have one v, and u grows along it.
template <typename Value>
using Net = std::array<std::array<Value, 4>, 4>;

/// Returns the weights of four control points at x, and their derivatives: Bernstein's polynomials.
inline std::array<double, 4> Weights(double x) {
  const double y = 1 - x;
  return {y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x};
}
inline std::array<double, 4> WeightSlopes(double x) {
  const double y = 1 - x;
  return {-3 * y * y, 3 * y * y - 6 * x * y, 6 * x * y - 3 * x * x, 3 * x * x};
}

template <typename Value>
Value Blend(const Net<Value>& net, const std::array<double, 4>& along_u, const std::array<double, 4>& along_v) {
  Value sum{};
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) sum = sum + along_v[j] * along_u[i] * net[j][i];
  return sum;
}

/// The distances of the line of a ray from control points, along two directions perpendicular to it.
struct Miss {
  double x = 0, y = 0;

  friend Miss operator+(const Miss& a, const Miss& b) { return {a.x + b.x, a.y + b.y}; }
  friend Miss operator-(const Miss& a, const Miss& b) { return {a.x - b.x, a.y - b.y}; }
  friend Miss operator*(double s, const Miss& a) { return {s * a.x, s * a.y}; }
};

/// The numbers from low to high.
struct Range {
  double low = infinity, high = -infinity;

  void Extend(double x) { low = std::min(low, x), high = std::max(high, x); }
  bool HoldsZero(double pad) const { return low <= pad && high >= -pad; }
  double Largest() const { return std::max(std::abs(low), std::abs(high)); }
  double Middle() const { return 0.5 * (low + high); }
  double Half() const { return 0.5 * (high - low); }
};

using Four = std::array<Miss, 4>;

/// Returns the control points of a curve up to x.
///   source   de Casteljau's construction
inline Four UpTo(double x, const Four& c) {
  const auto between = [x](const Miss& a, const Miss& b) { return a + x * (b - a); };
  const Miss a = between(c[0], c[1]), b = between(c[1], c[2]), d = between(c[2], c[3]);
  const Miss ab = between(a, b), bd = between(b, d);
  return {c[0], a, ab, between(ab, bd)};
}
inline Four From(double x, const Four& c) {
  const Four backwards = UpTo(1 - x, {c[3], c[2], c[1], c[0]});
  return {backwards[3], backwards[2], backwards[1], backwards[0]};
}
/// Returns the control points from `low` to `high`, which may be beyond the ends.
inline Four Stretch(double low, double high, const Four& c) {
  if (low == 0) return UpTo(high, c);
  return high == 1 ? From(low, c) : From(low / high, UpTo(high, c));
}

/// A rectangle of the patch, and the line's distances from its control points.
struct Cell {
  double u = 0, v = 0, du = 1, dv = 1;  // the smallest u and v, and the extent from there
  Net<Miss> net{};

  Cell AlongU(double low, double high) const {
    Cell part = *this;
    part.u = u + low * du, part.du = (high - low) * du;
    for (std::size_t j = 0; j < 4; ++j) part.net[j] = Stretch(low, high, net[j]);
    return part;
  }
  Cell AlongV(double low, double high) const {
    Cell part = *this;
    part.v = v + low * dv, part.dv = (high - low) * dv;
    for (std::size_t i = 0; i < 4; ++i) {
      const Four column = Stretch(low, high, {net[0][i], net[1][i], net[2][i], net[3][i]});
      for (std::size_t j = 0; j < 4; ++j) part.net[j][i] = column[j];
    }
    return part;
  }
};

/// Bounds on the derivatives of the distances over a cell whose u and v run from 0 to 1.
struct Slopes {
  Range x_of_u, y_of_u, x_of_v, y_of_v;

  double AlongU() const { return std::max(x_of_u.Largest(), y_of_u.Largest()); }
  double AlongV() const { return std::max(x_of_v.Largest(), y_of_v.Largest()); }
};

inline Slopes SlopesOf(const Net<Miss>& net) {
  Slopes slopes;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 3; ++i) {
      const Miss along_u = 3 * (net[j][i + 1] - net[j][i]), along_v = 3 * (net[i + 1][j] - net[i][j]);
      slopes.x_of_u.Extend(along_u.x), slopes.y_of_u.Extend(along_u.y);
      slopes.x_of_v.Extend(along_v.x), slopes.y_of_v.Extend(along_v.y);
    }
  return slopes;
}

/// A point of the patch, and whether it is proven to be the only one there.
struct Root {
  double u, v;
  bool is_proven;
  double du = 0, dv = 0;  // the sides of the cell in which it was found, if it is not proven
};

/// A search for all points where the line meets the patch.
///
/// A cell whose control points are all on one side of the line, along either of two directions, is missed. For others
/// Krawczyk's operator decides: with m the middle, Y the inverse of the slopes there, J the slopes anywhere in the
/// cell,
///     K = m - Y f(m) + (1 - Y J) (cell - m)
/// contains all zeros of f in the cell; if it lies within the cell there is exactly one. Otherwise the cell is split
/// into overlapping halves, so that a zero is well within one of them. The patch is extended a little beyond its edges
/// for the same reason. The cells that remain at the end are, seen along the line, no longer than the square root of
/// rounding: where a line touches the patch or lies in it, or within some 10^-7 of the patch's size of a corner of
/// coincident points. Newton's method is tried there too, without proof.
///   source   Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken (1969)
class RootFinder {
 public:
  explicit RootFinder(const Net<Miss>& net) {
    Range all;
    for (const auto& row : net)
      for (const Miss& miss : row) all.Extend(std::max(std::abs(miss.x), std::abs(miss.y)));
    // Every split rounds by less than 8 u, and there are at most 66.
    constexpr double roundings = 8 * 66;
    pad_ = roundings * unit_roundoff * all.high;
    // The surface bends away from a tangent line by about the square of the distance; below this size, rounding hides
    // it.
    smallest_ = std::sqrt(pad_);
    constexpr double beyond = 0x1p-6;
    waiting_.push_back(Cell{.net = net}.AlongU(-beyond, 1 + beyond).AlongV(-beyond, 1 + beyond));
    while (!waiting_.empty()) {
      const Cell cell = waiting_.back();
      waiting_.pop_back();
      Examine(cell);
    }
  }

  const std::vector<Root>& Roots() const { return roots_; }

 private:
  static constexpr int most_cells = 2'000;  // a line that lies in the patch would never end

  void Examine(const Cell& cell) {
    Range x, y;
    for (const auto& row : cell.net)
      for (const Miss& miss : row) x.Extend(miss.x), y.Extend(miss.y);
    if (!x.HoldsZero(pad_) || !y.HoldsZero(pad_)) return;
    if (PassesBeside(cell.net)) return;
    const Slopes slopes = SlopesOf(cell.net);
    if (IsDecided(cell, slopes)) return;
    const bool is_short = slopes.AlongU() < smallest_ && slopes.AlongV() < smallest_;
    if (is_short || ++cells_ > most_cells)
      return roots_.push_back({cell.u + cell.du / 2, cell.v + cell.dv / 2, false, cell.du, cell.dv});
    Halve(cell, slopes.AlongU() >= slopes.AlongV());
  }

  /// Returns true if all control points are on one side of the line, across the direction in which the cell is long as
  /// seen along it. Near a silhouette cells are narrow in that direction, and any other direction would leave more
  /// cells.
  bool PassesBeside(const Net<Miss>& net) const {
    const Miss along_u = net[3][3] - net[3][0] + (net[0][3] - net[0][0]);
    const Miss along_v = net[3][3] - net[0][3] + (net[3][0] - net[0][0]);
    const auto size = [](const Miss& m) { return std::abs(m.x) + std::abs(m.y); };
    const Miss along = size(along_u) > size(along_v) ? along_u : along_v;
    if (!(size(along) > 0)) return false;
    Range across;
    for (const auto& row : net)
      for (const Miss& m : row) across.Extend((along.x * m.y - along.y * m.x) / size(along));
    return !across.HoldsZero(2 * pad_);
  }

  /// Splits the cell where the net is longer.
  void Halve(const Cell& cell, bool is_u) {
    constexpr double first = 0.53125, second = 0.46875;
    waiting_.push_back(is_u ? cell.AlongU(second, 1) : cell.AlongV(second, 1));
    waiting_.push_back(is_u ? cell.AlongU(0, first) : cell.AlongV(0, first));
  }

  bool IsDecided(const Cell& cell, const Slopes& s) {
    const double a = s.x_of_u.Middle(), b = s.x_of_v.Middle(), c = s.y_of_u.Middle(), d = s.y_of_v.Middle();
    const double determinant = DifferenceOfProducts(a, d, b, c);
    if (!(std::abs(determinant) > 0)) return false;
    const double ya = d / determinant, yb = -b / determinant, yc = -c / determinant, yd = a / determinant;
    // |1 - Y J| for J within its ranges about the middle, times half a cell.
    const double half = 0.5;
    const double ru = half * (std::abs(ya) * (s.x_of_u.Half() + s.x_of_v.Half()) +
                              std::abs(yb) * (s.y_of_u.Half() + s.y_of_v.Half()));
    const double rv = half * (std::abs(yc) * (s.x_of_u.Half() + s.x_of_v.Half()) +
                              std::abs(yd) * (s.y_of_u.Half() + s.y_of_v.Half()));
    constexpr std::array<double, 4> middle{0.125, 0.375, 0.375, 0.125};
    const Miss at = Blend(cell.net, middle, middle);
    const double u = half - (ya * at.x + yb * at.y), v = half - (yc * at.x + yd * at.y);
    const double eu = ru + (std::abs(ya) + std::abs(yb)) * pad_, ev = rv + (std::abs(yc) + std::abs(yd)) * pad_;
    if (u + eu < 0 || u - eu > 1 || v + ev < 0 || v - ev > 1) return true;
    if (!(u - eu > 0 && u + eu < 1 && v - ev > 0 && v + ev < 1)) return false;
    roots_.push_back({cell.u + u * cell.du, cell.v + v * cell.dv, true});
    return true;
  }

  std::vector<Cell> waiting_;
  std::vector<Root> roots_;  // overlapping cells find a zero twice, each within its own rounding, and a touch often
  double pad_ = 0, smallest_ = 0;
  int cells_ = 0;
};

}  // namespace R3::patch
