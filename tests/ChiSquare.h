#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

/// Whether counts agree with the probabilities they should have: Pearson's test.
namespace chi_square {

/// What a normal variable of deviation 1 exceeds with this probability, in (0, 0.5).
inline double NormalQuantile(double exceeded_with) {
  double low = 0, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::sqrt(2.0)) / 2 > exceeded_with ? low : high) = middle;
  }
  return low;
}

/// What a chi-square variable exceeds with this probability; within 1 % for 10 degrees of freedom and more.
/// Source: Wilson, Hilferty, The distribution of chi-square (1931).
inline double Quantile(double degrees, double exceeded_with) {
  const double variance = 2 / (9 * degrees);
  return degrees * std::pow(1 - variance + NormalQuantile(exceeded_with) * std::sqrt(variance), 3);
}

/// The sum of (count - expected)^2 / expected over the quantile: above 1 with the probability `significance`, if the
/// counts are drawn with these probabilities. Cells of less than five expected counts are put together. Infinite when
/// a cell of probability 0 has a count.
inline double OverQuantile(const std::vector<double>& counts, const std::vector<double>& probabilities,
                           double significance) {
  double all = 0;
  for (const double n : counts) all += n;
  double sum = 0, rare_count = 0, rare_expected = 0;
  int cells = 0;
  const auto add = [&](double count, double expected) {
    sum += (count - expected) * (count - expected) / expected;
    ++cells;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = all * probabilities[i];
    if (!(expected > 0) && counts[i] > 0) return HUGE_VAL;
    if (expected >= 5) {
      add(counts[i], expected);
    } else {
      rare_count += counts[i], rare_expected += expected;
    }
  }
  if (rare_expected >= 5) add(rare_count, rare_expected);
  return cells < 2 ? 0 : sum / Quantile(cells - 1, significance);
}

}  // namespace chi_square
