#pragma once

#include <array>
#include <cstddef>

#include "source/film/denoise/LocalFit.h"

namespace ray {

/// A tile of a picture and as much around it as its fits look at, channel by channel, so that vector instructions work
/// on many pixels of a row at once.
class FitTile {
 public:
  // On the scenes of script/denoise_table.sh windows of 11 x 11 pixels had 3% more error for twice the time, patches
  // of 5 x 5 had 3% less but made claims less true: noise that a pixel is compared by must not be its own.
  static constexpr int window = 3;               // pixels to each side that a fit looks at
  static constexpr int patch = 1;                // pixels to each side that surroundings are compared by
  static constexpr int columns = 32, rows = 16;  // of a tile that no edge of the picture cuts; they change no bit
  static constexpr int most_lanes = 16;          // of a vector; those past the end of a row hold nothing of use

  static constexpr int margin = window + patch;
  static constexpr int pitch = margin + columns + margin + most_lanes;
  using Channel = std::array<float, std::size_t{pitch} * (rows + 2 * margin)>;

  /// The tile whose lower left pixel is x0, y0.
  void Load(const LocalFitInput& input, int x0, int y0);

  int Columns() const { return columns_; }
  int Rows() const { return rows_; }
  float StrengthSquared() const { return strength_squared_; }
  /// Where the tile's pixel x, y is in each channel.
  static constexpr std::ptrdiff_t At(int x, int y) { return std::ptrdiff_t{y + margin} * pitch + x + margin; }
  bool HasRow(int y) const { return y0_ + y >= 0 && y0_ + y < picture_rows_; }
  /// 1 for a column of the picture, else 0.
  const float* HasColumn(int x) const { return &has_column_[static_cast<std::size_t>(x + margin)]; }

  static constexpr std::size_t guide_count = std::tuple_size_v<PixelGuide>;
  alignas(64) std::array<Channel, guide_count> best{};        // of the tile alone
  alignas(64) std::array<Channel, guide_count> guides{};      // and of `window` pixels around it
  alignas(64) std::array<Channel, 3> colors{};                // as of guides
  alignas(64) std::array<Channel, 3> compared{}, variance{};  // and of `margin` pixels around it; outside the
                                                              // picture those of the nearest pixel in it

 private:
  /// Copies the values of the tile's pixels and of `around` pixels around it.
  template <std::size_t count, typename Function>
  void Copy(const Pixels<std::array<float, count>>& pixels, int around, const Function& function,
            std::array<Channel, count>& channels) const;

  int x0_ = 0, y0_ = 0, columns_ = 0, rows_ = 0, picture_rows_ = 0;
  float strength_squared_ = 1;
  std::array<float, pitch> has_column_{};
};

}  // namespace ray
