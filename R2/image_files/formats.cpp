#include "R2/image_files/formats.h"

#include <cassert>

namespace R2 {

ImageSize CheckedSize(const char* kind, std::int64_t width, std::int64_t height) {
  const auto promise = [&] {
    return std::string(kind) + " states " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  };
  if (width < 1 || height < 1) throw ImageError(promise() + "; at least one is required");
  // A quotient, because the product of two sides may overflow.
  if (width > max_pixels / height) {
    throw ImageError(promise() + ", above the limit of " + std::to_string(max_pixels));
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::vector<unsigned char> ByteRow(const Image& image, int y, const ImageEncoding& encoding) {
  std::vector<unsigned char> bytes(3 * static_cast<std::size_t>(image.Width()));
  auto to = bytes.begin();
  for (int x = 0; x < image.Width(); ++x) {
    const Color c = image.At(x, y);
    for (double channel : {c.r, c.g, c.b}) *to++ = ToByte(EncodedChannel(channel, encoding), encoding.quantization);
  }
  return bytes;
}

void SetByteRow(Image& image, int y, std::span<const unsigned char> bytes) {
  assert(bytes.size() == 3 * static_cast<std::size_t>(image.Width()));
  for (int x = 0; x < image.Width(); ++x) {
    const auto pixel = bytes.subspan(3 * static_cast<std::size_t>(x), 3);
    image.Set(x, y, {pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0});
  }
}

void WarnOfBytesBehind(DecodedImage& decoded, const char* kind, std::uint64_t bytes) {
  if (bytes == 0) return;
  decoded.warnings.push_back(
      std::string(kind) + " has " + std::to_string(bytes) +
      (bytes == 1 ? " byte after its image, which is ignored" : " bytes after its image, which are ignored"));
}

}  // namespace R2
