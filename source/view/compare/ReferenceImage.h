#pragma once

#include <memory>

#include "R2/Image.h"
#include "R2/ImageFile.h"

namespace ray {

/// The encoding of light in an image file of bytes.
struct ByteEncoding {
  bool srgb = false;
  R2::Quantization quantization = R2::Quantization::rounded;
  friend bool operator==(const ByteEncoding&, const ByteEncoding&) = default;
};

/// An image that others are compared with: linear light, or values quantized as in a file of whole numbers, which are
/// compared with equally quantized values.
struct ReferenceImage {
  std::shared_ptr<const R2::Image> image;  // as the file has it, 0 to 1 for whole numbers; null for none
  int levels = 0;                          // the largest whole number of a channel, 255 or 65535; 0: the image is light

  explicit operator bool() const { return image != nullptr; }
  bool IsLight() const { return levels == 0; }
  /// Returns the image as linear light: the image itself if it is light.
  std::shared_ptr<const R2::Image> AsLight(const ByteEncoding& encoding) const;
  /// Returns `light` as such a file would hold it: clamped, encoded and quantized; unchanged if the reference is light.
  R2::Image Comparable(const R2::Image& light, const ByteEncoding& encoding) const;
};

/// The reference that a decoded file is: light for formats of light, else of 255 levels, or of 65535 where values lie
/// between those.
ReferenceImage ReferenceOf(R2::DecodedImage decoded);

}  // namespace ray
