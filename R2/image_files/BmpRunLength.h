#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/image_files/BmpHeader.h"

namespace R2::bmp {

/// The places in the palette of a run-length encoded bitmap, row by row as the file has them.
struct Places {
  std::vector<unsigned char> places;
  std::vector<std::string> warnings;
  std::uint64_t bytes_behind = 0;
};

/// Pixels that the file passes over have place 0. Throws ImageError when the file ends before the bitmap does, and when
/// it is too small for its pixels. source: Microsoft, "Bitmap Compression", Win32 reference
Places ReadRunLengths(std::span<const unsigned char> pixels, const Header& header);

}  // namespace R2::bmp
