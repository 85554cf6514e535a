#pragma once

#include <span>

#include "R2/ImageFile.h"

namespace R2 {

/// How the rows that a file stores lie in the picture. As a rule the first one is the top row, from the left.
struct Orientation {
  bool rows_are_columns = false;
  bool from_right = false;   // the first column of the picture that is stored is the rightmost one
  bool from_bottom = false;  // the first row of the picture that is stored is the lowest one

  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// What the orientation of a block of EXIF asks for. One that lacks it, or is damaged, asks for nothing: no viewer
/// refuses a picture for that.
/// source   CIPA DC-008 (2012), Exif 2.3, section 4.6.4; TIFF 6.0 (1992), sections 2 and 8
Orientation ExifOrientation(std::span<const unsigned char> exif);

/// The size of a picture that is stored with `size.width` pixels a row.
ImageSize Turned(ImageSize size, const Orientation& orientation);

/// Turns an image whose rows are those that the file stores, from the top.
void Turn(DecodedImage& decoded, const Orientation& orientation);

}  // namespace R2
