#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/image_files/BmpHeader.h"

namespace R2::bmp {

/// The palette indices of a run-length encoded bitmap, row by row in file order.
struct Places {
  std::vector<unsigned char> places;
  std::vector<std::string> warnings;
  std::uint64_t bytes_behind = 0;
};

/// Decodes run lengths. Pixels that the file skips have index 0. Throws ImageError if the file ends before the bitmap,
/// or is too small for its pixels.
/// source: Microsoft, "Bitmap Compression", Win32 reference
Places ReadRunLengths(std::span<const unsigned char> pixels, const Header& header);

}  // namespace R2::bmp
