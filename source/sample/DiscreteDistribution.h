#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "source/sample/Random.h"

namespace ray {

/// Importance sampling of indices: draws them with probabilities proportional to given weights.
///   source   inversion of the running sums, as in Pharr, Jakob, Humphreys, Physically Based Rendering (2023), A.1,
///            begun near the end as by Chen, Asau, On generating random variates from an empirical distribution (1974)
class DiscreteDistribution {
 public:
  struct Drawn {
    std::size_t index = 0;
    double probability = 0;  // > 0
    double rest = 0;         // in [0, 1): u spread anew over what led to this index, for use as another number
  };

  /// At least one weight; each finite and >= 0 (asserted), however large or small. All 0 count as all equal.
  explicit DiscreteDistribution(std::span<const double> weights);

  /// In O(log Size()), mostly less.
  ///   u   in [0, 1]; of its 53 bits about log2(1 / probability) are used up, the others are left in `rest`
  Drawn Draw(double u) const;

  /// Where Draw(u) looks first, and, found by that, where it looks next: for those who prefetch what many draws from
  /// large tables will need.
  const std::uint32_t* FirstLookup(double u) const { return &first_of_part_[PartOf(SumAt(u))]; }
  const double* NextLookup(double u) const { return &sums_[*FirstLookup(u)]; }

  /// Probability that Draw returns `index` for a uniform u: weight / sum of weights, within Size() 2^-53. Exactly what
  /// Draw does rather than what the weight says, so a weight lost in the rounding of the sum has probability 0 and is
  /// never drawn.
  double Probability(std::size_t index) const;

  /// Where Probability(index) looks.
  const double* LookupOf(std::size_t index) const { return &sums_[index]; }

  std::size_t Size() const { return sums_.size() - 1; }

 private:
  /// Less than the last sum, also when rounded.
  double SumAt(double u) const { return std::min(u, below_one) * sum_; }
  /// Index of the part that `sum` is in when the sum of all weights is cut into Size() equal parts.
  std::size_t PartOf(double sum) const { return std::min(static_cast<std::size_t>(sum * parts_per_sum_), Size()); }

  std::vector<double> sums_;  // of the weights before each index, and of all, in units of the largest weight
  double sum_;                // their total
  double parts_per_sum_;
  std::vector<std::uint32_t> first_of_part_;  // the least index whose weight's end is in a part or beyond
};

}  // namespace ray
