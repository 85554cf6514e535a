#pragma once

#include <array>
#include <vector>

namespace ray {

/// Reconstruction filters: how much a sample counts for a pixel, by its distance from the pixel's center along x times
/// that along y. The course also numbers them in this order.
///   box       1 up to half a pixel
///   gaussian  exp(-2 x^2) less its value at 2 pixels, up to 2 pixels: standard deviation half a pixel
///   mitchell  Mitchell and Netravali, Reconstruction filters in computer graphics (1988), B = C = 1/3, up to 2 pixels
///   lanczos   sinc(x) sinc(x / 3) up to 3 pixels: Duchon, Lanczos filtering in one and two dimensions (1979)
enum class FilterKind { box, gaussian, mitchell, lanczos };
inline constexpr std::array filter_names{"box", "gaussian", "mitchell", "lanczos"};
constexpr const auto& NamesOf(FilterKind) { return filter_names; }

/// A filter along one axis, from a table: within 1e-6 of the formula.
class Filter {
 public:
  explicit Filter(FilterKind kind);

  FilterKind Kind() const { return kind_; }
  bool IsBox() const { return kind_ == FilterKind::box; }
  /// In pixels; nothing farther from a pixel's center counts for it.
  double Radius() const { return radius_; }
  /// How many pixels to each side a sample may count for, besides the one it is in.
  int Apron() const { return IsBox() ? 0 : static_cast<int>(radius_); }
  /// Weight at a distance in pixels, of either sign; 0 at the radius and beyond.
  double operator()(double distance) const;

 private:
  FilterKind kind_;
  double radius_;
  std::vector<double> table_;
};

/// The formula the table is made from.
double FilterFormula(FilterKind kind, double distance);

}  // namespace ray
