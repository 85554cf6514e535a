#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace R2 {

struct ExrChannel {
  std::string name;  // as the file has it: any bytes
  ImageChannel::Type type = ImageChannel::Type::float32;
  int bytes = 4;  // a sample
  int x_sampling = 1, y_sampling = 1;
};

/// A rectangle of pixels, y down; its corners may lie on any side of the origin.
struct ExrWindow {
  std::int64_t left = 0, top = 0;
  ImageSize size;

  std::int64_t Right() const { return left + size.width; }   // beyond the last column
  std::int64_t Bottom() const { return top + size.height; }  // beyond the last row
};

/// How an OpenEXR file of a single flat part is laid out, read without its library: that one believes every size in
/// the header, and makes room for it.
/// source: OpenEXR File Layout (2013)
struct ExrLayout {
  ExrWindow data, display;  // the pixels that are stored, and those that are the image
  std::vector<ExrChannel> channels;
  int compression = 0;  // by the number that the file has
  bool is_tiled = false;
  std::uint64_t tile_width = 0, tile_height = 0;
  bool has_smaller_copies = false;
  std::uint64_t table = 0;  // where the header ends and the table of the blocks' places starts
};

/// Throws ImageError, also when an attribute does not lie within the file, and for an image that is hardly more than
/// margin: see CheckMargin.
ExrLayout ReadExrLayout(std::span<const unsigned char> bytes);

/// Throws ImageError unless every block of rows or tiles lies within the file and holds all its pixels. The library
/// does not ask, and fills the rest with what its memory held before.
///   returns   where the last of them ends
std::uint64_t CheckExrBlocks(std::span<const unsigned char> bytes, const ExrLayout& layout);

}  // namespace R2
