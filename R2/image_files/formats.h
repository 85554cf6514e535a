#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "R2/ImageFile.h"

/// Checks and conversions that the image file formats share.
namespace R2 {

/// Returns the size that a header states, after checking that it is at least 1 by 1 and at most max_pixels. Otherwise
/// throws ImageError with the name of the format.
ImageSize CheckedSize(const char* kind, std::int64_t width, std::int64_t height);

/// Returns the value that an 8 or 16 bit format stores.
inline double EncodedChannel(double channel, const ImageEncoding& encoding) {
  return encoding.srgb ? EncodeSrgb(channel) : channel;
}

/// Returns one row as bytes, three (r, g, b) per pixel; y from the bottom.
std::vector<unsigned char> ByteRow(const Image& image, int y, const ImageEncoding& encoding);

/// Sets one row from bytes, three (r, g, b) per pixel, without any curve.
void SetByteRow(Image& image, int y, std::span<const unsigned char> bytes);

/// Adds a warning if bytes follow the image: the header may not state what its writer meant.
void WarnOfBytesBehind(DecodedImage& decoded, const char* kind, std::uint64_t bytes);

}  // namespace R2
