#pragma once

#include <array>
#include <cstddef>

#include "source/film/denoise/LocalFit.h"

namespace ray {

/// A tile of an image, and the pixels around it that its fits read. Stored by channel, so that vector instructions work
/// on many pixels of a row at once.
class FitTile {
 public:
  // On the scenes of script/denoise_table.sh windows of 11 x 11 pixels had 3% more error in twice the time. Patches of
  // 5 x 5 had 3% less error but less accurate error estimates: the noise by which a pixel is compared must not be its
  // own.
  static constexpr int window = 3;               // pixels on each side that a fit reads
  static constexpr int patch = 1;                // pixels on each side by which surroundings are compared
  static constexpr int columns = 32, rows = 16;  // size of a tile that is not cut by the image; changes no bit
  static constexpr int most_lanes = 16;          // of a vector; those past the end of a row are unused

  static constexpr int margin = window + patch;
  static constexpr int pitch = margin + columns + margin + most_lanes;
  using Channel = std::array<float, std::size_t{pitch} * (rows + 2 * margin)>;

  /// Loads the tile whose lower left pixel is x0, y0.
  void Load(const LocalFitInput& input, int x0, int y0);

  int Columns() const { return columns_; }
  int Rows() const { return rows_; }
  float StrengthSquared() const { return strength_squared_; }
  /// Returns the index of the tile's pixel x, y in each channel.
  static constexpr std::ptrdiff_t At(int x, int y) { return std::ptrdiff_t{y + margin} * pitch + x + margin; }
  bool HasRow(int y) const { return y0_ + y >= 0 && y0_ + y < image_rows_; }
  /// Returns 1 for a column of the image, otherwise 0.
  const float* HasColumn(int x) const { return &has_column_[static_cast<std::size_t>(x + margin)]; }

  static constexpr std::size_t guide_count = std::tuple_size_v<PixelGuide>;
  alignas(64) std::array<Channel, guide_count> best{};        // of the tile alone
  alignas(64) std::array<Channel, guide_count> guides{};      // of the tile and `window` pixels around it
  alignas(64) std::array<Channel, 3> colors{};                // for the same pixels as guides
  alignas(64) std::array<Channel, 3> compared{}, variance{};  // of the tile and `margin` pixels around it; outside the
                                                              // image, those of its nearest pixel

 private:
  /// Copies the values of the tile's pixels and of `around` pixels around it.
  template <std::size_t count, typename Function>
  void Copy(const Pixels<std::array<float, count>>& pixels, int around, const Function& function,
            std::array<Channel, count>& channels) const;

  int x0_ = 0, y0_ = 0, columns_ = 0, rows_ = 0, image_rows_ = 0;
  float strength_squared_ = 1;
  std::array<float, pitch> has_column_{};
};

}  // namespace ray
