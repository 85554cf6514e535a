#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace R2 {

struct ExrChannel {
  std::string name;  // as in the file: any bytes
  ImageChannel::Type type = ImageChannel::Type::float32;
  int bytes = 4;  // per sample
  int x_sampling = 1, y_sampling = 1;
};

/// A rectangle of pixels, y down; its corners may lie on any side of the origin.
struct ExrWindow {
  std::int64_t left = 0, top = 0;
  ImageSize size;

  std::int64_t Right() const { return left + size.width; }   // one past the last column
  std::int64_t Bottom() const { return top + size.height; }  // one past the last row
};

/// The layout of an OpenEXR file with a single flat part. It is read without the library, because that trusts every
/// size in the header and allocates memory for it.
/// source: OpenEXR File Layout (2013)
struct ExrLayout {
  ExrWindow data, display;  // the stored pixels, and those of the visible image
  std::vector<ExrChannel> channels;
  int compression = 0;  // the number in the file
  bool is_tiled = false;
  std::uint64_t tile_width = 0, tile_height = 0;
  bool has_smaller_copies = false;
  std::uint64_t table = 0;  // the end of the header and start of the table of block offsets
};

/// Reads the layout. Throws ImageError, also if an attribute is not inside the file, or if the image is almost only
/// margin: see CheckMargin.
ExrLayout ReadExrLayout(std::span<const unsigned char> bytes);

/// Throws ImageError unless every block of rows or tiles is inside the file and contains all its pixels. The library
/// does not check this, and leaves the missing pixels uninitialized.
///   returns   the end of the last block
std::uint64_t CheckExrBlocks(std::span<const unsigned char> bytes, const ExrLayout& layout);

}  // namespace R2
