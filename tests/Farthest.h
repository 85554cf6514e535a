#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "R2/Image.h"

/// The largest difference of a channel of two images; infinite where their sizes differ.
inline double Farthest(const R2::Image& a, const R2::Image& b) {
  const auto &p = a.Channels(), &q = b.Channels();
  if (a.Width() != b.Width() || p.size() != q.size()) return std::numeric_limits<double>::infinity();
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) farthest = std::max(farthest, double{std::abs(p[i] - q[i])});
  return farthest;
}
