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

/// A sum of weighted samples.
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

/// The contribution of samples taken in one block to its own pixels and, if the filter is wider than a pixel, to those
/// around it.
class BlockSums {
 public:
  BlockSums() = default;
  /// `reach`: the pixels to which samples may contribute.
  explicit BlockSums(const PixelRectangle& reach);

  /// Splats a sample at x, y, in pixels from the lower left corner of the image, taken in pixel (column, row).
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

  /// The sums, for checkpoints.
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

/// Collects the samples of an image in two parts, whose difference shows the error of their mean, and computes pixels
/// from them. Work is divided into blocks of 8x8 pixels, each of which belongs to one thread at a time. Within a block
/// samples are added in a fixed order, and a pixel adds up the blocks that reach it in a fixed order, so neither
/// threads nor the tile size can change a bit.
class Film {
 public:
  static constexpr int block_side = BlockOrder::side, parts = 2;

  /// `region`: the requested part of the image. Samples are also taken in pixels around it that contribute to it, so
  /// that it equals the same part of the whole image.
  /// `surroundings`: the number of pixels around the region that are computed as well, for denoisers and comparisons of
  /// neighbors.
  /// `together`: the side, in blocks, of the squares of the image in which samples are taken together.
  Film(int image_width, int image_height, const PixelRectangle& region, FilterKind filter, int surroundings = 0,
       int together = 1);

  int Columns() const { return columns_; }
  int Blocks() const { return columns_ * rows_; }
  int Together() const { return together_; }
  /// Returns the pixels in which a block takes samples.
  PixelRectangle PixelsOf(int block) const;
  /// Returns the block's pixels that are in the region.
  PixelRectangle PixelsInRegion(int block) const { return Common(PixelsOf(block), region_); }
  /// Returns, for each block, its number of pixels in the region.
  std::vector<double> AreasInRegion() const;
  const Filter& filter() const { return filter_; }
  const PixelRectangle& Region() const { return region_; }
  /// The region and its surroundings, clipped to the image.
  const PixelRectangle& Made() const { return made_; }
  /// The pixels in which samples are taken: Made(), those around it from which a wide filter reaches it, and those
  /// whose samples are taken together with these.
  const PixelRectangle& Sampled() const { return sampled_; }

  /// The samples of one block.
  struct Block {
    BlockSums sums[parts];
    std::uint32_t samples[parts] = {0, 0};  // per pixel
    // The first samples (sample 0 of the first stream) at the first places of BlockOrder, until whole samples are
    // added. Black at places outside of the image.
    std::vector<R2::Color> first_samples;

    std::uint32_t Samples() const { return samples[0] + samples[1]; }
    /// Returns the samples of each stream: if the parts are two streams, both have equally many; otherwise one stream
    /// fills both parts.
    std::uint32_t SamplesPerStream(bool has_two_streams) const { return has_two_streams ? samples[0] : Samples(); }
  };
  const Block& operator[](int block) const { return blocks_[static_cast<std::size_t>(block)]; }
  Block& operator[](int block) { return blocks_[static_cast<std::size_t>(block)]; }
  BlockSums EmptySums(int block) const;

  /// Returns the image so far. If blocks have different sample counts, each block counts by the mean of its samples.
  /// Pixels without samples are filled from those around, see FillGaps; without any samples, the image is black.
  ///   quantization   how the image will be converted to bytes; its floats are chosen to give the bytes of the exact
  ///                  sums
  R2::Image Image(R2::Quantization quantization = R2::Quantization::rounded) const;
  /// Returns the image of one part alone; black where it has no samples.
  R2::Image Part(int part) const;
  /// Returns the film of a part of the region, with the samples of its blocks.
  Film Cut(const PixelRectangle& part) const;
  bool HasSurroundings() const { return !(made_ == region_); }
  /// Returns a copy whose region is Made().
  Film WithSurroundings() const;
  /// Returns true if every block of the region has samples in both parts.
  bool HasBothParts() const;
  /// Returns the block that contains a pixel of the region.
  int BlockOf(int x, int y) const;

 private:
  bool HasGaps() const;
  void FillUnsampled(R2::Image& image) const;
  template <typename Blend>
  R2::Image Composed(R2::Quantization quantization, const Blend& blend) const;

  Filter filter_;
  PixelRectangle region_, made_, sampled_;
  int together_;
  int first_column_, first_row_, columns_, rows_;
  std::vector<Block> blocks_;
};

}  // namespace ray
