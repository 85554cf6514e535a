#pragma once

#include <string>
#include <vector>

#include "R2/Image.h"

namespace ray::rayimg {

/// A picture with the words below it.
struct Tile {
  R2::Image image;
  std::string caption;
};

/// Pictures in rows, from the upper left, on white.
struct SheetLayout {
  std::size_t columns = 1;  // at least 1
  int gap = 0;              // pixels between pictures
  int margin = 0;           // pixels around all
  bool has_captions = false;
};

/// All of a row have one height (asserted). Captions that are too long lose their middle; characters that are not ASCII
/// are shown as boxes.
R2::Image Arranged(const std::vector<Tile>& tiles, const SheetLayout& layout);

/// The image in the middle of a white one, which is at least as large.
R2::Image Padded(const R2::Image& image, int width, int height);

}  // namespace ray::rayimg
