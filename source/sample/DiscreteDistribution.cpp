#include "source/sample/DiscreteDistribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace ray {

DiscreteDistribution::DiscreteDistribution(std::span<const double> weights) {
  assert(!weights.empty());
  const double largest = *std::max_element(weights.begin(), weights.end());
  sums_.reserve(weights.size() + 1);
  sums_.push_back(0);
  for (const double weight : weights) {
    assert(std::isfinite(weight) && weight >= 0);
    sums_.push_back(sums_.back() + (largest > 0 ? weight / largest : 1));
  }
  sum_ = sums_.back();
  parts_per_sum_ = static_cast<double>(Size()) / sum_;
  for (std::uint32_t i = 0; i < Size(); ++i)
    while (first_of_part_.size() <= PartOf(sums_[i + 1])) first_of_part_.push_back(i);
}

DiscreteDistribution::Drawn DiscreteDistribution::Draw(double u) const {
  const double target = SumAt(u);
  // The first sum beyond the target: the step to it is never empty, so no index of weight 0 is drawn.
  const std::size_t part = PartOf(target);
  const auto end_of = [&](std::size_t index) { return sums_.begin() + static_cast<std::ptrdiff_t>(index) + 1; };
  const auto last = part + 1 < first_of_part_.size() ? end_of(first_of_part_[part + 1]) : std::prev(sums_.end());
  const auto after = std::upper_bound(end_of(first_of_part_[part]), last, target);
  const double before = *std::prev(after), step = *after - before;
  return {static_cast<std::size_t>(after - sums_.begin()) - 1, step / sum_,
          std::min((target - before) / step, below_one)};
}

double DiscreteDistribution::Probability(std::size_t index) const {
  return (sums_[index + 1] - sums_[index]) / sum_;
}

}  // namespace ray
