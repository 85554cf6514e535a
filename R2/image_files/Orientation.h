#pragma once

#include <span>

#include "R2/ImageFile.h"

namespace R2 {

/// The orientation of the stored rows in the image. By default the first stored row is the top row, from left to right.
struct Orientation {
  bool rows_are_columns = false;
  bool from_right = false;   // the first stored column is the rightmost of the image
  bool from_bottom = false;  // the first stored row is the bottom row of the image

  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// Returns the orientation stored in an EXIF block; the default if it is missing or damaged, because no viewer rejects
/// an image for that.
/// source   CIPA DC-008 (2012), Exif 2.3, section 4.6.4; TIFF 6.0 (1992), sections 2 and 8
Orientation ExifOrientation(std::span<const unsigned char> exif);

/// Returns the size of an image that is stored with `size.width` pixels per row.
ImageSize Turned(ImageSize size, const Orientation& orientation);

/// Reorients an image whose rows are in stored order, from the top.
void Turn(DecodedImage& decoded, const Orientation& orientation);

}  // namespace R2
