#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace R2::bmp {

/// The bits of a 16 or 32 bit pixel that form a channel.
struct BitField {
  std::uint32_t mask = 0;

  /// Returns the channel from 0 to 1; 0 if it has no bits.
  double Value(std::uint32_t pixel) const {
    return mask == 0 ? 0 : static_cast<double>(pixel & mask) / static_cast<double>(mask);
  }
  friend bool operator==(const BitField&, const BitField&) = default;
};

struct BitFields {
  BitField red{0xff0000}, green{0xff00}, blue{0xff}, alpha{};
  friend bool operator==(const BitFields&, const BitFields&) = default;
};

/// The header of a bitmap: everything before its pixels.
struct Header {
  ImageSize size;
  bool is_top_down = false;
  int bits = 24;  // per pixel: 1, 2, 4 and 8 are palette indices, 16 and 32 have bit fields
  bool is_run_length = false;
  BitFields fields;
  std::span<const unsigned char> palette;  // blue, green, red, and an unused byte if entries have four
  std::size_t palette_entry = 4;           // bytes
  std::uint64_t pixels_start = 0;          // in the file
  std::uint64_t profile_bytes = 0;         // of a color profile behind the pixels
  std::vector<std::string> warnings;

  bool HasPalette() const { return bits <= 8; }
  std::uint64_t RowBytes() const {
    return (std::uint64_t{1} * static_cast<unsigned>(size.width) * static_cast<unsigned>(bits) + 7) / 8;
  }
  /// Returns the bytes per row, padded to a multiple of four.
  std::uint64_t RowStride() const { return (RowBytes() + 3) / 4 * 4; }
};

/// Reads the header. Throws ImageError. Supports the headers of Windows since version 2 and of OS/2.
/// source: Microsoft, "BITMAPCOREHEADER", "BITMAPINFOHEADER" and "BITMAPV5HEADER", Win32 reference; IBM, OS/2 Warp 4
///         Presentation Manager Programming Reference, "BITMAPINFOHEADER2"
Header ReadHeader(std::span<const unsigned char> file);

}  // namespace R2::bmp
