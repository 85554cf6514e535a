#pragma once

#include <array>
#include <cstddef>

namespace ray {

/// Weighted linear least squares of three channels on `size` regressors, of which the first is 1: its normal equations,
/// added up point by point.
template <std::size_t size>
class Regression {
 public:
  using Regressors = std::array<double, size>;
  using Channels = std::array<double, 3>;

  void Add(double weight, const Regressors& z, const Channels& value) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double weighted = weight * z[i];
      for (std::size_t j = 0; j <= i; ++j) products_[at++] += weighted * z[j];
      for (std::size_t k = 0; k < value.size(); ++k) sides_[k][i] += weighted * value[k];
    }
  }

  double TotalWeight() const { return products_[0]; }

  /// The channels where all regressors but the first are 0.
  ///   ridge     of each regressor: how much of the sum of the weights is added to the diagonal; above 0 but for the
  ///             first, so that regressors that do not vary, or vary together, do no harm
  ///   source    symmetric Gaussian elimination; ridge regression by Hoerl and Kennard (1970)
  Channels Intercepts(const Regressors& ridge) const {
    std::array<double, size*(size + 1) / 2> factor = products_;
    for (std::size_t i = 0; i < size; ++i) factor[Diagonal(i)] += ridge[i] * TotalWeight();
    // The unknown wanted comes first; eliminated from the last upwards, it is what is left.
    Channels intercepts{};
    std::array<Regressors, 3> sides = sides_;
    for (std::size_t pivot = size - 1; pivot > 0; --pivot) {
      const double* row = &factor[Diagonal(pivot) - pivot];
      for (std::size_t i = 0; i < pivot; ++i) {
        const double share = row[i] / row[pivot];
        double* target = &factor[Diagonal(i) - i];
        for (std::size_t j = 0; j <= i; ++j) target[j] -= share * row[j];
        for (std::size_t k = 0; k < 3; ++k) sides[k][i] -= share * sides[k][pivot];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) intercepts[k] = sides[k][0] / factor[0];
    return intercepts;
  }

 private:
  static constexpr std::size_t Diagonal(std::size_t i) { return i * (i + 3) / 2; }

  std::array<double, size*(size + 1) / 2> products_{};  // lower triangle, in rows
  std::array<Regressors, 3> sides_{};
};

}  // namespace ray
