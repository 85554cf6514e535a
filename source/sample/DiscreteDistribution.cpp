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
}

DiscreteDistribution::Drawn DiscreteDistribution::Draw(double u) const {
  constexpr double below_one = 1 - 0x1p-53;
  const double target = std::min(u, below_one) * sums_.back();  // less than the last sum, also when rounded
  // The first sum beyond the target: the step to it is never empty, so no index of weight 0 is drawn.
  const auto after = std::upper_bound(sums_.begin() + 1, sums_.end(), target);
  const double before = *std::prev(after), step = *after - before;
  return {static_cast<std::size_t>(after - sums_.begin()) - 1, step / sums_.back(),
          std::min((target - before) / step, below_one)};
}

double DiscreteDistribution::Probability(std::size_t index) const {
  return (sums_[index + 1] - sums_[index]) / sums_.back();
}

}  // namespace ray
