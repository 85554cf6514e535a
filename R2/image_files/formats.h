#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "R2/ImageFile.h"

/// Checks and conversions that the kinds of image file have in common.
namespace R2 {

/// The size a header promises, once it is known to be at least 1 by 1 and at most max_pixels. Throws ImageError
/// with the name of the kind otherwise.
ImageSize CheckedSize(const char* kind, std::int64_t width, std::int64_t height);

/// The value an 8 or 16 bit kind stores.
inline double EncodedChannel(double channel, const ImageEncoding& encoding) {
  return encoding.srgb ? EncodeSrgb(channel) : channel;
}

/// One row as bytes, three (r, g, b) per pixel; y from the bottom.
std::vector<unsigned char> ByteRow(const Image& image, int y, const ImageEncoding& encoding);

/// The inverse, without any curve; `bytes` holds three (r, g, b) per pixel of the row.
void SetByteRow(Image& image, int y, std::span<const unsigned char> bytes);

/// Adds a warning when bytes are left over behind the picture: the header may say something else than its writer meant.
void WarnOfBytesBehind(DecodedImage& decoded, const char* kind, std::uint64_t bytes);

}  // namespace R2
