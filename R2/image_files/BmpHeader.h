#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace R2::bmp {

/// Which bits of a pixel of 16 or 32 bits are a channel.
struct BitField {
  std::uint32_t mask = 0;

  /// The channel from 0 to 1; 0 where it has no bits.
  double Value(std::uint32_t pixel) const {
    return mask == 0 ? 0 : static_cast<double>(pixel & mask) / static_cast<double>(mask);
  }
  friend bool operator==(const BitField&, const BitField&) = default;
};

struct BitFields {
  BitField red{0xff0000}, green{0xff00}, blue{0xff}, alpha{};
  friend bool operator==(const BitFields&, const BitFields&) = default;
};

/// What a bitmap says before its pixels.
struct Header {
  ImageSize size;
  bool is_top_down = false;
  int bits = 24;  // per pixel: 1, 2, 4 and 8 are places in a palette, 16 and 32 have bit fields
  bool is_run_length = false;
  BitFields fields;
  std::span<const unsigned char> palette;  // blue, green, red, and where an entry has four bytes one that is unused
  std::size_t palette_entry = 4;           // bytes
  std::uint64_t pixels_start = 0;          // in the file
  std::uint64_t profile_bytes = 0;         // of a color profile behind the pixels
  std::vector<std::string> warnings;

  bool HasPalette() const { return bits <= 8; }
  std::uint64_t RowBytes() const {
    return (std::uint64_t{1} * static_cast<unsigned>(size.width) * static_cast<unsigned>(bits) + 7) / 8;
  }
  /// Rows start at multiples of four bytes.
  std::uint64_t RowStride() const { return (RowBytes() + 3) / 4 * 4; }
};

/// Throws ImageError. Knows the headers of Windows since version 2 and of OS/2.
/// source: Microsoft, "BITMAPCOREHEADER", "BITMAPINFOHEADER" and "BITMAPV5HEADER", Win32 reference; IBM, OS/2 Warp 4
///         Presentation Manager Programming Reference, "BITMAPINFOHEADER2"
Header ReadHeader(std::span<const unsigned char> file);

}  // namespace R2::bmp
