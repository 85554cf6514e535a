#include "source/film/Film.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "source/film/FillGaps.h"

namespace ray {
namespace {

/// Returns the float next to x that is truncated to the same byte as x: rounding to float must not lift a value to the
/// next byte.
double TruncatedAlike(double x) {
  const auto byte = R2::ToByte(x, R2::Quantization::truncated);
  const auto is_alike = [&](float f) { return R2::ToByte(f, R2::Quantization::truncated) == byte; };
  const auto nearest = static_cast<float>(x);
  if (is_alike(nearest)) return nearest;
  return std::nextafter(nearest, x < nearest ? -std::numeric_limits<float>::max() : std::numeric_limits<float>::max());
}

R2::Color Normalized(const WeightedSum& sum, R2::Quantization quantization) {
  // The weights of a filter with negative lobes may cancel if samples are few. Such a pixel is black.
  if (sum.weight == 0) return {};
  const R2::Color mean = sum.color / sum.weight;
  if (quantization == R2::Quantization::rounded) return mean;
  const R2::Color storable = R2::Storable(mean);
  return {TruncatedAlike(storable.r), TruncatedAlike(storable.g), TruncatedAlike(storable.b)};
}

}  // namespace

BlockSums::BlockSums(const PixelRectangle& reach) : reach_(reach), sums_(static_cast<std::size_t>(reach.Area())) {}

void BlockSums::Splat(int column, int row, double x, double y, const R2::Color& sample, const Filter& filter) {
  const int apron = filter.Apron();
  const PixelRectangle near = Common(reach_, Grown({column, row, column + 1, row + 1}, apron));
  double along_x[16];  // 2 apron + 1 of them
  for (int i = near.x0; i < near.x1; ++i) along_x[i - near.x0] = filter(x - (i + 0.5));
  for (int j = near.y0; j < near.y1; ++j) {
    const double along_y = filter(y - (j + 0.5));
    if (along_y == 0) continue;
    WeightedSum* sums = &sums_[Index(near.x0, j)];
    for (int i = 0; i < near.Width(); ++i) sums[i].Add(along_x[i] * along_y, sample);
  }
}

BlockSums& BlockSums::operator+=(const BlockSums& o) {
  if (sums_.empty()) return *this = o;
  for (std::size_t i = 0; i < o.sums_.size(); ++i) sums_[i] += o.sums_[i];
  return *this;
}

Film::Film(int image_width, int image_height, const PixelRectangle& region, FilterKind filter, int surroundings,
           int together)
    : filter_(filter),
      region_(region),
      made_(Common({0, 0, image_width, image_height}, Grown(region, surroundings))),
      sampled_(Common({0, 0, image_width, image_height},
                      InSquares(Grown(made_, filter_.Apron()), together > 1 ? together * block_side : 1))),
      together_(together),
      first_column_(sampled_.x0 / block_side),
      first_row_(sampled_.y0 / block_side),
      columns_((sampled_.x1 + block_side - 1) / block_side - first_column_),
      rows_((sampled_.y1 + block_side - 1) / block_side - first_row_),
      blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

PixelRectangle Film::PixelsOf(int block) const {
  const int x = (first_column_ + block % columns_) * block_side, y = (first_row_ + block / columns_) * block_side;
  return Common(sampled_, {x, y, x + block_side, y + block_side});
}

std::vector<double> Film::AreasInRegion() const {
  std::vector<double> areas;
  for (int i = 0; i < Blocks(); ++i) areas.push_back(static_cast<double>(PixelsInRegion(i).Area()));
  return areas;
}

int Film::BlockOf(int x, int y) const {
  return (y / block_side - first_row_) * columns_ + (x / block_side - first_column_);
}

bool Film::HasBothParts() const {
  for (int i = 0; i < Blocks(); ++i)
    if (PixelsInRegion(i).Area() > 0 && ((*this)[i].samples[0] == 0 || (*this)[i].samples[1] == 0)) return false;
  return true;
}

Film Film::Cut(const PixelRectangle& part) const {
  Film cut(sampled_.x1, sampled_.y1, part, filter_.Kind());
  for (int i = 0; i < cut.Blocks(); ++i) {
    const PixelRectangle pixels = cut.PixelsOf(i);
    cut[i] = (*this)[BlockOf(pixels.x0, pixels.y0)];
  }
  return cut;
}

Film Film::WithSurroundings() const {
  Film all = *this;
  all.region_ = made_;
  return all;
}

BlockSums Film::EmptySums(int block) const { return BlockSums(Common(made_, Grown(PixelsOf(block), filter_.Apron()))); }

bool Film::HasGaps() const {
  for (int i = 0; i < Blocks(); ++i)
    if ((*this)[i].Samples() == 0 && PixelsInRegion(i).Area() > 0) return true;
  return false;
}

/// Fills the pixels without samples, in blocks that lack them, from the first samples of the others.
void Film::FillUnsampled(R2::Image& image) const {
  std::vector<char> is_known(static_cast<std::size_t>(region_.Area()), 1);
  tbb::parallel_for(0, Blocks(), [&](int i) {
    const Block& block = (*this)[i];
    if (block.Samples() > 0) return;
    const PixelRectangle pixels = PixelsInRegion(i);
    for (int y = pixels.y0; y < pixels.y1; ++y)
      for (int x = pixels.x0; x < pixels.x1; ++x) {
        const auto place = static_cast<std::size_t>(BlockOrder::PlaceOf(x, y));
        const bool is_seen = place < block.first_samples.size();
        if (is_seen) image.Store(x - region_.x0, y - region_.y0, block.first_samples[place]);
        is_known[static_cast<std::size_t>(y - region_.y0) * static_cast<std::size_t>(region_.Width()) +
                 static_cast<std::size_t>(x - region_.x0)] = is_seen;
      }
  });
  FillGaps(image, region_.x0, region_.y0, std::move(is_known));
}

R2::Image Film::Image(R2::Quantization quantization) const {
  R2::Image image = Composed(quantization, [](const Block& block, int x, int y) {
    WeightedSum sum;
    for (int part = 0; part < parts; ++part)
      if (block.samples[part] > 0) sum += block.sums[part].At(x, y);
    const double n = block.Samples();
    return WeightedSum{sum.color / n, sum.weight / n};
  });
  if (HasGaps()) FillUnsampled(image);
  return image;
}

R2::Image Film::Part(int part) const {
  return Composed(R2::Quantization::rounded, [&](const Block& block, int x, int y) {
    const double n = block.samples[part];
    if (n == 0) return WeightedSum{};
    const WeightedSum& sum = block.sums[part].At(x, y);
    return WeightedSum{sum.color / n, sum.weight / n};
  });
}

template <typename Blend>
R2::Image Film::Composed(R2::Quantization quantization, const Blend& blend) const {
  R2::Image image(region_.Width(), region_.Height());
  const int reach = (filter_.Apron() + block_side - 1) / block_side;  // in blocks
  tbb::parallel_for(region_.y0, region_.y1, [&](int y) {
    for (int x = region_.x0; x < region_.x1; ++x) {
      const int column = x / block_side - first_column_, row = y / block_side - first_row_;
      WeightedSum sum;
      if (reach == 0) {  // a single block, independent of its neighbors
        const Block& own = (*this)[row * columns_ + column];
        if (own.Samples() == 0) continue;  // black, the initial value of images
        sum = blend(own, x, y);
        image.Store(x - region_.x0, y - region_.y0, Normalized(sum, quantization));
        continue;
      }
      for (int r = std::max(0, row - reach); r <= std::min(rows_ - 1, row + reach); ++r)
        for (int c = std::max(0, column - reach); c <= std::min(columns_ - 1, column + reach); ++c) {
          const Block& block = (*this)[r * columns_ + c];
          if (block.Samples() == 0) continue;
          const int part_with_sums = block.samples[0] > 0 ? 0 : 1;
          if (block.sums[part_with_sums].Reach().Contains(x, y)) sum += blend(block, x, y);
        }
      image.Store(x - region_.x0, y - region_.y0, Normalized(sum, quantization));
    }
  });
  return image;
}

}  // namespace ray
