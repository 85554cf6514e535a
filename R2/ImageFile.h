#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "R2/Image.h"

/// Image files. One kind a file in R2/image_files/, one line each in image_formats.def.
namespace R2 {

/// What was wrong with an image file, in words; names no file, the caller knows it.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Words kept in the picture itself: program, command, seed... Written to JPEG, PNG and EXR.
using ImageSettings = std::map<std::string, std::string>;

/// How a value in [0, 1] becomes a whole number of 8 or 16 bits: the nearest one to 255 v, or that number's whole part.
enum class Quantization { rounded, truncated };
inline constexpr std::array quantization_names{"rounded", "truncated"};
constexpr const auto& NamesOf(Quantization) { return quantization_names; }

/// How to write.
struct ImageEncoding {
  bool srgb = false;  // encode with the sRGB curve; otherwise the values are written straight (8 and 16 bit formats)
  int bits = 8;       // 8 or 16, PNG only
  int jpeg_quality = 95;  // 1..100; chroma is never subsampled
  Quantization quantization = Quantization::rounded;
};

/// Further channels that a file can hold beside the picture, of the same size: up to three, each with its name.
struct ImageLayer {
  std::vector<std::string> channels;
  Image image;  // the first of its channels are those named
};

/// Width and height, both at least 1, their product at most max_pixels.
struct ImageSize {
  int width = 0, height = 0;
};

/// A channel as a file stores it.
struct ImageChannel {
  enum class Type { uint32, half16, float32 };

  std::string name;  // any bytes
  Type type = Type::float32;
};
inline constexpr std::array channel_type_names{"uint", "half", "float"};
constexpr const auto& NamesOf(ImageChannel::Type) { return channel_type_names; }

/// A rectangle of pixels, as EXR counts them: columns x0 to x1 and rows y0 to y1, both included, y down.
struct ImageWindow {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// What a file of named channels holds.
struct ImageChannels {
  std::vector<ImageChannel> channels;  // in the file's order
  ImageWindow data, display;           // the pixels that are stored, and those that are the image
};

struct ImageFormat;

/// What an image decodes to.
struct DecodedImage {
  Image image;
  const ImageFormat* format = nullptr;
  ImageSettings settings{};
  std::vector<std::string> warnings{};  // what is odd about the file, or left out of it; sentences that name no file
  bool is_turned = false;               // from how the file stores it, as the file asks
};

/// One line of image_formats.def.
struct ImageFormat {
  const char* name;                                              // "png"
  std::vector<const char*> extensions;                           // lower case, without the dot
  bool (*recognizes)(std::span<const unsigned char> bytes);      // by content, never by name
  ImageSize (*read_size)(std::span<const unsigned char> bytes);  // from the header; throws ImageError
  DecodedImage (*decode)(std::span<const unsigned char> bytes);  // throws ImageError; sets no format
  std::vector<unsigned char> (*encode)(const Image& image, const ImageEncoding& encoding,
                                       const ImageSettings& settings);
  bool is_linear;  // PFM, HDR, EXR hold linear light: never sRGB-decoded, never clamped
  /// With further channels; null for formats that hold none.
  std::vector<unsigned char> (*encode_layers)(const Image& image, std::span<const ImageLayer> layers,
                                              const ImageSettings& settings) = nullptr;
  /// Without decoding a pixel; throws ImageError. Null for formats that hold none.
  ImageSettings (*read_settings)(std::span<const unsigned char> bytes) = nullptr;
  /// The channels by name, without decoding a pixel; throws ImageError. Null for formats whose channels have none.
  ImageChannels (*read_channels)(std::span<const unsigned char> bytes) = nullptr;
  /// Up to three channels of those names as the r, g and b of an image; one alone is gray, of two b is 0. Throws
  /// ImageError, also where the file has none of a name.
  DecodedImage (*decode_channels)(std::span<const unsigned char> bytes, std::span<const std::string> names) = nullptr;
};

/// Every format this build can read and write, in the order of image_formats.def.
std::span<const ImageFormat> ImageFormats();

/// The format for an output name, by its extension in any letter case; null when there is none.
const ImageFormat* FormatForName(const std::string& name);

/// Reads an image from the bytes of its file; the kind is decided by content. 8-bit kinds give value/255 (16-bit
/// value/65535), without any curve. Throws ImageError on anything truncated, malformed or over max_pixels,
/// before memory for the pixels is asked for.
DecodedImage DecodeImage(std::span<const unsigned char> bytes);

/// Width and height from the header alone, for a quick check. Throws ImageError.
ImageSize ReadImageSize(std::span<const unsigned char> bytes);

/// What an image file says of itself.
struct ImageHeader {
  ImageSize size;
  const ImageFormat* format = nullptr;
  ImageSettings settings;
};

/// Without decoding a pixel, so that a small file of a large image costs nothing. Throws ImageError.
ImageHeader ReadImageHeader(std::span<const unsigned char> bytes);

/// A channel, clamped to [0, 1], as a number from 0 to `most`; NaN, which fails the first comparison, gives 0.
template <class Whole>
Whole Quantized(double channel, double most, Quantization how) {
  if (!(channel > 0)) return 0;
  return static_cast<Whole>(std::min(channel, 1.0) * most + (how == Quantization::rounded ? 0.5 : 0));
}

/// 8-bit value of a channel, clamped to [0, 1]; NaN gives 0.
inline unsigned char ToByte(double channel, Quantization how = Quantization::rounded) {
  return Quantized<unsigned char>(channel, 255, how);
}
/// 16-bit value of a channel, clamped to [0, 1]; NaN gives 0.
inline unsigned short ToShort(double channel, Quantization how = Quantization::rounded) {
  return Quantized<unsigned short>(channel, 65535, how);
}

}  // namespace R2
