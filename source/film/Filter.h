#pragma once

#include <array>
#include <vector>

namespace ray {

/// Reconstruction filters. The weight of a sample for a pixel is the product of the filter's values at its distances
/// from the pixel's center along x and y. The course also numbers them in this order.
///   box       1 up to half a pixel
///   gaussian  exp(-2 x^2) minus its value at 2 pixels, up to 2 pixels: standard deviation half a pixel
///   mitchell  Mitchell and Netravali, Reconstruction filters in computer graphics (1988), B = C = 1/3, up to 2 pixels
///   lanczos   sinc(x) sinc(x / 3) up to 3 pixels: Duchon, Lanczos filtering in one and two dimensions (1979)
enum class FilterKind { box, gaussian, mitchell, lanczos };
inline constexpr std::array filter_names{"box", "gaussian", "mitchell", "lanczos"};
constexpr const auto& NamesOf(FilterKind) { return filter_names; }

/// A filter along one axis, from a table that is within 1e-6 of the formula.
class Filter {
 public:
  explicit Filter(FilterKind kind);

  FilterKind Kind() const { return kind_; }
  bool IsBox() const { return kind_ == FilterKind::box; }
  /// The distance from a pixel's center, in pixels, beyond which samples do not contribute to it.
  double Radius() const { return radius_; }
  /// Returns the number of pixels on each side of its own to which a sample may contribute.
  int Apron() const { return IsBox() ? 0 : static_cast<int>(radius_); }
  /// Returns the weight at a distance in pixels, of either sign; 0 at the radius and beyond.
  double operator()(double distance) const;

 private:
  FilterKind kind_;
  double radius_;
  std::vector<double> table_;
};

/// Evaluates the formula of the table.
double FilterFormula(FilterKind kind, double distance);

}  // namespace ray
