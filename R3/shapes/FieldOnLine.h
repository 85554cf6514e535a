#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "R3/Numeric.h"

/// The points along a line where the sum of the fields of balls reaches 1.
namespace R3::field {

/// The part of a line inside a ball. Its field at s is strength q^3, with q = height - bend (s - middle)^2, where q is
/// above 0.
struct Chord {
  double middle, height, bend, strength;
  double enter, leave;

  double Share(double s) const { return height - bend * (s - middle) * (s - middle); }
};

/// The coefficients of a polynomial in Bernstein form: those of a stretch bound its values there, and it has no more
/// zeros there than they have sign changes.
template <std::size_t size>
using Bernstein = std::array<double, size>;

constexpr double Choose(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return result;
}

/// Multiplies two polynomials. source   Farouki, Rajan, Algorithms for polynomials in Bernstein form (1988), eq. 44
template <std::size_t m, std::size_t n>
Bernstein<m + n - 1> operator*(const Bernstein<m>& a, const Bernstein<n>& b) {
  Bernstein<m + n - 1> product{};
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      product[i + j] += Choose(m - 1, i) * Choose(n - 1, j) / Choose(m + n - 2, i + j) * a[i] * b[j];
  return product;
}

/// A stretch of the line within the same balls, with the field minus 1 there, a polynomial of degree six.
struct Cell {
  double low, high;
  bool begins_inside, ends_inside;
  Bernstein<7> field;
};

/// All crossings in order, each computed on request.
///
/// Between the points where the line enters or leaves a ball the field is a polynomial. A stretch whose coefficients
/// have one sign contains no crossing; one whose coefficients change their sign once contains one, which Newton's
/// method finds; others are bisected, the nearer half first. So nothing is skipped. If all coefficients are within
/// rounding of 0, as where a line touches the surface, the signs at the ends decide. The sign at a point is that of one
/// function, whichever stretch it is an end of: the line alternates between in and out.
///   source   Descartes' rule of signs in Bernstein form: Lane, Riesenfeld, Bounds on a polynomial (1981)
class FieldOnLine {
 public:
  void Add(const Chord& chord) { chords_.push_back(chord), most_ += std::abs(chord.strength); }

  /// Returns the first crossing s for which `is_wanted` is true; it must stay true for all later ones. No crossing
  /// depends on it.
  template <class IsWanted>
  std::optional<double> First(const IsWanted& is_wanted) {
    std::vector<double> ends;
    for (const Chord& chord : chords_) ends.insert(ends.end(), {chord.enter, chord.leave});
    std::ranges::sort(ends);
    // Products and sums of a coefficient are fewer than 64 roundings, and every bisection adds 6, of numbers that do
    // not exceed 8 times the strengths: q is below 1, and its Bernstein coefficients are below 2.
    constexpr int roundings = 64 + 6 * most_halvings;
    pad_ = Gamma(roundings) * (8 * most_ + 1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (!(ends[i] < ends[i + 1]) || !is_wanted(ends[i + 1])) continue;
      const Cell cell = CellOf(ends[i], ends[i + 1]);
      if (const auto s = FirstIn(cell, most_halvings, is_wanted)) return s;
    }
    return {};
  }

 private:
  static constexpr int most_halvings = 52;

  /// Returns the field minus 1, and its derivative.
  std::array<double, 2> At(double s) const {
    double value = -1, slope = 0;
    for (const Chord& chord : chords_) {
      const double q = chord.Share(s);
      if (!(q > 0)) continue;
      value += chord.strength * q * q * q;
      slope -= 6 * chord.strength * chord.bend * (s - chord.middle) * q * q;
    }
    return {value, slope};
  }
  bool IsInside(double s) const { return At(s)[0] > 0; }

  Cell CellOf(double low, double high) const {
    Cell cell{low, high, IsInside(low), IsInside(high), {-1, -1, -1, -1, -1, -1, -1}};
    for (const Chord& c : chords_) {
      if (!(c.enter <= low && c.leave >= high)) continue;
      // Blossoming gives the middle coefficient.
      const Bernstein<3> q{c.Share(low), c.height - c.bend * (low - c.middle) * (high - c.middle), c.Share(high)};
      const Bernstein<7> cube = q * q * q;
      for (std::size_t i = 0; i < cube.size(); ++i) cell.field[i] += c.strength * cube[i];
    }
    return cell;
  }

  /// Returns the maximum number of sign changes for any values of the uncertain coefficients, up to 2.
  int SignChanges(const Bernstein<7>& c) const {
    const auto sign = [&](double x) { return x > pad_ ? 1 : x < -pad_ ? -1 : 0; };
    if (sign(c.front()) == 0 || sign(c.back()) == 0) return 2;
    // Between consecutive certain signs there is at most one change; uncertain ones between two equal signs may hide
    // two.
    int changes = 0, last = sign(c.front());
    bool is_between = false;
    for (std::size_t i = 1; i < c.size(); ++i) {
      if (sign(c[i]) == 0) {
        is_between = true;
      } else {
        changes += sign(c[i]) != last ? 1 : is_between ? 2 : 0;
        last = sign(c[i]), is_between = false;
      }
    }
    return std::min(changes, 2);
  }

  template <class IsWanted>
  std::optional<double> FirstIn(const Cell& cell, int halvings, const IsWanted& is_wanted) {
    if (!is_wanted(cell.high)) return {};
    const int changes = SignChanges(cell.field);
    if (changes == 0) return {};
    const bool is_known = std::ranges::any_of(cell.field, [&](double c) { return std::abs(c) > pad_; });
    const double middle = cell.low + (cell.high - cell.low) / 2;
    if (changes > 1 && halvings > 0 && is_known && cell.low < middle && middle < cell.high) {
      const auto [first, second] = Halves(cell, middle);
      if (const auto s = FirstIn(first, halvings - 1, is_wanted)) return s;
      return FirstIn(second, halvings - 1, is_wanted);
    }
    if (cell.begins_inside == cell.ends_inside) return {};
    const double s = CrossingIn(cell);
    return is_wanted(s) ? std::optional(s) : std::nullopt;
  }

  /// Splits a cell. source   de Casteljau's construction
  std::array<Cell, 2> Halves(const Cell& cell, double middle) const {
    Cell first = cell, second = cell;
    first.high = second.low = middle;
    first.ends_inside = second.begins_inside = IsInside(middle);
    Bernstein<7> points = cell.field;
    for (std::size_t left = points.size(); left-- > 0;) {
      first.field[points.size() - 1 - left] = points[0], second.field[left] = points[left];
      for (std::size_t i = 0; i < left; ++i) points[i] = 0.5 * (points[i] + points[i + 1]);
    }
    return {first, second};
  }

  /// Finds the crossing by Newton's method within a bracket, which is bisected if a step leaves it or is not half of
  /// the last one.
  double CrossingIn(const Cell& cell) const {
    double low = cell.low, high = cell.high, step = high - low, s = low + step / 2;
    constexpr int most_steps = 128;  // at least every second one bisects the bracket
    for (int i = 0; i < most_steps; ++i) {
      const auto [value, slope] = At(s);
      ((value > 0) == cell.begins_inside ? low : high) = s;
      double next = s - value / slope;
      if (!(next > low && next < high && std::abs(next - s) < step / 2)) next = low + (high - low) / 2;
      step = std::abs(next - s), s = next;
      if (step <= 2 * unit_roundoff * std::abs(s)) break;
    }
    return s;
  }

  std::vector<Chord> chords_;
  double most_ = 0, pad_ = 0;
};

}  // namespace R3::field
