#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "R2/Image.h"

/// Image files. One file per format in R2/image_files/, one line each in image_formats.def.
namespace R2 {

/// An error in an image file. The message does not name the file, since the caller knows it.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Text stored in the image file: program, command, seed... Written to JPEG, PNG and EXR.
using ImageSettings = std::map<std::string, std::string>;

/// The conversion of v in [0, 1] to an integer of 8 or 16 bits: 255 v rounded to nearest, or truncated.
enum class Quantization { rounded, truncated };
inline constexpr std::array quantization_names{"rounded", "truncated"};
constexpr const auto& NamesOf(Quantization) { return quantization_names; }

/// Settings for writing an image.
struct ImageEncoding {
  bool srgb = false;  // encode with the sRGB curve; otherwise values are written linearly (8 and 16 bit formats)
  int bits = 8;       // 8 or 16, PNG only
  int jpeg_quality = 95;  // 1..100; chroma is never subsampled
  Quantization quantization = Quantization::rounded;
};

/// Up to three additional named channels that a file stores next to the image, of the same size.
struct ImageLayer {
  std::vector<std::string> channels;
  Image image;  // its first channels are the named ones
};

/// Width and height in pixels, both at least 1, their product at most max_pixels.
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

/// A rectangle of pixels in EXR's convention: columns x0 to x1 and rows y0 to y1, inclusive, y down.
struct ImageWindow {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The contents of a file with named channels.
struct ImageChannels {
  std::vector<ImageChannel> channels;  // in the file's order
  ImageWindow data, display;           // the stored pixels, and those of the visible image
};

struct ImageFormat;

/// A decoded image.
struct DecodedImage {
  Image image;
  const ImageFormat* format = nullptr;
  ImageSettings settings{};
  std::vector<std::string> warnings{};  // oddities and unsupported parts; sentences that do not name the file
  bool is_turned = false;               // stored in another orientation, as stated by the file
};

/// One line of image_formats.def.
struct ImageFormat {
  const char* name;                                              // "png"
  std::vector<const char*> extensions;                           // lower case, without the dot
  bool (*recognizes)(std::span<const unsigned char> bytes);      // by content, not by file name
  ImageSize (*read_size)(std::span<const unsigned char> bytes);  // from the header; throws ImageError
  DecodedImage (*decode)(std::span<const unsigned char> bytes);  // throws ImageError; leaves `format` unset
  std::vector<unsigned char> (*encode)(const Image& image, const ImageEncoding& encoding,
                                       const ImageSettings& settings);
  bool is_linear;  // PFM, HDR and EXR store linear light: never sRGB-decoded, never clamped
  /// Encodes the image with additional channels; null for formats that cannot store any.
  std::vector<unsigned char> (*encode_layers)(const Image& image, std::span<const ImageLayer> layers,
                                              const ImageSettings& settings) = nullptr;
  /// Reads the settings without decoding pixels; throws ImageError. Null for formats without settings.
  ImageSettings (*read_settings)(std::span<const unsigned char> bytes) = nullptr;
  /// Lists the named channels without decoding pixels; throws ImageError. Null for formats without named channels.
  ImageChannels (*read_channels)(std::span<const unsigned char> bytes) = nullptr;
  /// Decodes up to three named channels as r, g and b of an image; one channel gives gray, and with two, b is 0. Throws
  /// ImageError, also if the file lacks one of the channels.
  DecodedImage (*decode_channels)(std::span<const unsigned char> bytes, std::span<const std::string> names) = nullptr;
};

/// Returns all supported formats, in the order of image_formats.def.
std::span<const ImageFormat> ImageFormats();

/// Returns the format for the extension of an output name, in any letter case, or null.
const ImageFormat* FormatForName(const std::string& name);

/// Decodes the bytes of an image file; the content determines the format. 8-bit formats give value/255 (16-bit
/// value/65535), without any curve. Throws ImageError on anything truncated, malformed or over max_pixels, before
/// allocating memory for the pixels.
DecodedImage DecodeImage(std::span<const unsigned char> bytes);

/// Reads width and height from the header alone, for a quick check. Throws ImageError.
ImageSize ReadImageSize(std::span<const unsigned char> bytes);

/// The header of an image file: size, format and settings.
struct ImageHeader {
  ImageSize size;
  const ImageFormat* format = nullptr;
  ImageSettings settings;
};

/// Reads the header without decoding pixels, so that a small file of a large image costs nothing. Throws ImageError.
ImageHeader ReadImageHeader(std::span<const unsigned char> bytes);

/// Converts a channel, clamped to [0, 1], to an integer from 0 to `most`; NaN, which fails the first comparison, gives
/// 0.
template <class Whole>
Whole Quantized(double channel, double most, Quantization how) {
  if (!(channel > 0)) return 0;
  return static_cast<Whole>(std::min(channel, 1.0) * most + (how == Quantization::rounded ? 0.5 : 0));
}

/// Returns the 8-bit value of a channel, clamped to [0, 1]; NaN gives 0.
inline unsigned char ToByte(double channel, Quantization how = Quantization::rounded) {
  return Quantized<unsigned char>(channel, 255, how);
}
/// Returns the 16-bit value of a channel, clamped to [0, 1]; NaN gives 0.
inline unsigned short ToShort(double channel, Quantization how = Quantization::rounded) {
  return Quantized<unsigned short>(channel, 65535, how);
}

}  // namespace R2
