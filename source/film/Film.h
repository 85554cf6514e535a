#pragma once

#include <cstdint>
#include <vector>

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/ImageFile.h"
#include "source/film/BlockOrder.h"
#include "source/film/Filter.h"
#include "source/film/PixelRectangle.h"

namespace ray {

/// Weighted samples added up.
struct WeightedSum {
  R2::Color color;
  double weight = 0;

  void Add(double w, const R2::Color& sample) {
    color += w * sample;
    weight += w;
  }
  WeightedSum& operator+=(const WeightedSum& o) {
    color += o.color;
    weight += o.weight;
    return *this;
  }
  friend bool operator==(const WeightedSum&, const WeightedSum&) = default;
};

/// What a number of samples from the pixels of one block add to these pixels and, through a filter wider than a pixel,
/// to those around.
class BlockSums {
 public:
  BlockSums() = default;
  /// `reach`: the pixels that samples may count for.
  explicit BlockSums(const PixelRectangle& reach);

  /// Splats a sample at x, y, in pixels from the lower left corner of the picture, taken in pixel (column, row).
  void Add(int column, int row, double x, double y, const R2::Color& sample, const Filter& filter) {
    if (filter.IsBox())
      sums_[Index(column, row)].Add(1, sample);
    else
      Splat(column, row, x, y, sample, filter);
  }

  const PixelRectangle& Reach() const { return reach_; }
  const WeightedSum& At(int x, int y) const { return sums_[Index(x, y)]; }
  BlockSums& operator+=(const BlockSums& o);
  bool IsEmpty() const { return sums_.empty(); }

  /// For checkpoints.
  const std::vector<WeightedSum>& Sums() const { return sums_; }
  std::vector<WeightedSum>& Sums() { return sums_; }

 private:
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y - reach_.y0) * static_cast<std::size_t>(reach_.Width()) +
           static_cast<std::size_t>(x - reach_.x0);
  }
  void Splat(int column, int row, double x, double y, const R2::Color& sample, const Filter& filter);

  PixelRectangle reach_;
  std::vector<WeightedSum> sums_;
};

/// Collects samples of a picture in two parts, whose difference shows the error of their mean, and makes pixels of
/// them. Work is shared out by blocks of 8x8 pixels, one thread at a time each: within a block samples are added in a
/// fixed order, and a pixel adds up the blocks that reach it in a fixed order. So neither threads nor the size of tiles
/// can change a bit.
class Film {
 public:
  static constexpr int block_side = BlockOrder::side, parts = 2;

  /// `region`: the part of the picture that is wanted. Samples from pixels around it that count for it are taken too,
  /// so that it equals the same part of the whole. `surroundings`: how many pixels around it are made as well, for
  /// denoisers and other neighbors to look at.
  Film(int picture_width, int picture_height, const PixelRectangle& region, FilterKind filter, int surroundings = 0);

  int Columns() const { return columns_; }
  int Blocks() const { return columns_ * rows_; }
  /// The pixels that a block takes samples of.
  PixelRectangle PixelsOf(int block) const;
  /// The block's pixels that are in the region.
  PixelRectangle PixelsInRegion(int block) const { return Common(PixelsOf(block), region_); }
  /// The number of pixels in the region, of each block.
  std::vector<double> AreasInRegion() const;
  const Filter& filter() const { return filter_; }
  const PixelRectangle& Region() const { return region_; }
  /// The region and its surroundings, as far as there is a picture.
  const PixelRectangle& Made() const { return made_; }
  /// The pixels that samples are taken of: those made, and those around them that a wide filter reaches them from.
  const PixelRectangle& Sampled() const { return sampled_; }

  /// What one block has collected.
  struct Block {
    BlockSums sums[parts];
    std::uint32_t samples[parts] = {0, 0};  // per pixel
    // Sample 0 of the first stream at the first places of BlockOrder, until whole samples are added; black where the
    // picture has no pixel.
    std::vector<R2::Color> first_samples;

    std::uint32_t Samples() const { return samples[0] + samples[1]; }
    /// Where the parts are two streams each has as many, else one stream is in both.
    std::uint32_t SamplesPerStream(bool has_two_streams) const { return has_two_streams ? samples[0] : Samples(); }
  };
  const Block& operator[](int block) const { return blocks_[static_cast<std::size_t>(block)]; }
  Block& operator[](int block) { return blocks_[static_cast<std::size_t>(block)]; }
  BlockSums EmptySums(int block) const;

  /// The picture so far. With several sample counts, a block's samples count by their mean. Pixels without samples are
  /// filled from those around, see FillGaps; where the whole picture has none, they are black.
  ///   quantization   how the picture will be made bytes; its floats are chosen so that theirs are those of the exact
  ///   sums
  R2::Image Picture(R2::Quantization quantization = R2::Quantization::rounded) const;
  /// The image from one part alone; black where it has no samples.
  R2::Image Part(int part) const;
  /// The film of a part of the region, with what its blocks have collected.
  Film Cut(const PixelRectangle& part) const;
  bool HasSurroundings() const { return !(made_ == region_); }
  /// A copy whose region is all that is made.
  Film WithSurroundings() const;
  /// Whether every block of the region has samples of both parts.
  bool HasBothParts() const;
  /// The block of a pixel of the region.
  int BlockOf(int x, int y) const;

 private:
  bool HasGaps() const;
  void FillUnsampled(R2::Image& image) const;
  template <typename Blend>
  R2::Image Composed(R2::Quantization quantization, const Blend& blend) const;

  Filter filter_;
  PixelRectangle region_, made_, sampled_;
  int first_column_, first_row_, columns_, rows_;
  std::vector<Block> blocks_;
};

}  // namespace ray
