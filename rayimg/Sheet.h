#pragma once

#include <string>
#include <vector>

#include "R2/Image.h"

namespace ray::rayimg {

/// An image with its caption.
struct Tile {
  R2::Image image;
  std::string caption;
};

/// The layout of images in rows, from the upper left, on white.
struct SheetLayout {
  std::size_t columns = 1;  // at least 1
  int gap = 0;              // pixels between images
  int margin = 0;           // pixels around all
  bool has_captions = false;
};

/// Arranges the tiles. Images in a row must have the same height (asserted). Captions that are too long lose their
/// middle; non-ASCII characters are shown as boxes.
R2::Image Arranged(const std::vector<Tile>& tiles, const SheetLayout& layout);

/// Returns the image centered in a white one, which is at least as large.
R2::Image Padded(const R2::Image& image, int width, int height);

}  // namespace ray::rayimg
