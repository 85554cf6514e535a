#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "source/sample/Random.h"

namespace ray {

/// A discrete distribution for importance sampling: draws indices with probabilities proportional to given weights.
///   source   inversion of the running sums, as in Pharr, Jakob, Humphreys, Physically Based Rendering (2023), A.1,
///            started near the end as by Chen, Asau, On generating random variates from an empirical distribution
///            (1974)
class DiscreteDistribution {
 public:
  struct Drawn {
    std::size_t index = 0;
    double probability = 0;  // > 0
    double rest = 0;         // u rescaled to [0, 1) within the range of this index, for reuse as another random number
  };

  /// Makes a distribution from at least one weight; each finite and >= 0 (asserted), however large or small. If all
  /// weights are 0, all indices are equally likely.
  explicit DiscreteDistribution(std::span<const double> weights);

  /// Draws an index in O(log Size()), usually less.
  ///   u   in [0, 1]; about log2(1 / probability) of its 53 bits are used up, the others remain in `rest`
  Drawn Draw(double u) const;

  /// Returns the address that Draw(u) reads first; the second address depends on its value. For callers that prefetch
  /// for many draws from large tables.
  const std::uint32_t* FirstLookup(double u) const { return &first_of_part_[PartOf(SumAt(u))]; }
  const double* NextLookup(double u) const { return &sums_[*FirstLookup(u)]; }

  /// Returns the probability that Draw returns `index` for a uniform u: weight / sum of weights, within Size() 2^-53.
  /// This is exactly the probability in Draw, so a weight lost in the rounding of the sum has probability 0 and is
  /// never drawn.
  double Probability(std::size_t index) const;

  /// Returns the address that Probability(index) reads.
  const double* LookupOf(std::size_t index) const { return &sums_[index]; }

  std::size_t Size() const { return sums_.size() - 1; }

 private:
  /// Returns the target sum for u, which is less than the last sum, also when rounded.
  double SumAt(double u) const { return std::min(u, below_one) * sum_; }
  /// Returns the index of the part that contains `sum` if the sum of all weights is divided into Size() equal parts.
  std::size_t PartOf(double sum) const { return std::min(static_cast<std::size_t>(sum * parts_per_sum_), Size()); }

  std::vector<double> sums_;  // of the weights before each index, and of all, in units of the largest weight
  double sum_;                // their total
  double parts_per_sum_;
  std::vector<std::uint32_t> first_of_part_;  // per part, the smallest index whose weight ends in the part or beyond
};

}  // namespace ray
