#include "source/film/Resize.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ray {
namespace {

/// The pixels that contribute to one pixel of a line of another length: those from `first` on, with weights that sum to
/// 1.
struct Contributors {
  int first = 0;
  std::vector<double> weights;
};

/// Returns the length of the part of pixel i between two places.
double Overlap(int i, double low, double high) {
  return std::max(0.0, std::min(high, i + 1.0) - std::max(low, static_cast<double>(i)));
}

Contributors ContributorsTo(int pixel, int old_length, int new_length, const Filter& filter) {
  const double scale = static_cast<double>(old_length) / new_length, size = std::max(1.0, scale);
  const double low = pixel * scale, center = low + scale / 2;
  const double radius = filter.IsBox() ? scale / 2 : filter.Radius() * size;
  const int first = std::max(0, static_cast<int>(std::floor(center - radius)));
  const int last = std::min(old_length - 1, static_cast<int>(std::ceil(center + radius)));
  Contributors found{first, {}};
  double sum = 0;
  for (int i = first; i <= last; ++i) {
    const double weight = filter.IsBox() ? Overlap(i, low, low + scale) : filter((i + 0.5 - center) / size);
    found.weights.push_back(weight);
    sum += weight;
  }
  for (double& weight : found.weights) weight /= sum;
  return found;
}

std::vector<Contributors> AllContributors(int old_length, int new_length, FilterKind kind) {
  const Filter filter(kind);
  std::vector<Contributors> all;
  for (int i = 0; i < new_length; ++i) all.push_back(ContributorsTo(i, old_length, new_length, filter));
  return all;
}

/// Returns the weighted sum. Skips elements of weight 0, since they may not be finite.
template <class At>
R2::Color Sum(const Contributors& contributors, const At& at) {
  R2::Color sum;
  for (std::size_t k = 0; k < contributors.weights.size(); ++k)
    if (contributors.weights[k] != 0) sum += contributors.weights[k] * at(contributors.first + static_cast<int>(k));
  return sum;
}

}  // namespace

R2::Image Resized(const R2::Image& image, int width, int height, FilterKind filter) {
  if (width == image.Width() && height == image.Height() && filter == FilterKind::box) return image;
  R2::Image narrow(width, image.Height()), resized(width, height);
  const auto columns = AllContributors(image.Width(), width, filter);
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < width; ++x)
      narrow.Set(x, y, Sum(columns[static_cast<std::size_t>(x)], [&](int i) { return image.At(i, y); }));
  const auto rows = AllContributors(image.Height(), height, filter);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      resized.Set(x, y, Sum(rows[static_cast<std::size_t>(y)], [&](int j) { return narrow.At(x, j); }));
  return resized;
}

}  // namespace ray
