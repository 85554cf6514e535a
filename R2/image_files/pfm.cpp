#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Portable float maps: linear floats, bottom row first, color (PF) or gray (Pf). Written as PF, little-endian.
// source: Debevec, "PFM Portable FloatMap Image Format", www.pauldebevec.com/Research/HDR/PFM
namespace R2 {

namespace pfm {
namespace {

struct Header {
  int channels = 3;
  ImageSize size;
  double scale = 1;
  bool is_little_endian = true;

  std::uint64_t PixelBytes() const {
    return std::uint64_t{4} * static_cast<unsigned>(channels) * static_cast<unsigned>(size.width) *
           static_cast<unsigned>(size.height);
  }
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f');
}

double ReadScale(ByteReader& reader) {
  const std::string_view word = reader.Word("the scale");
  double scale = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), scale);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(scale) || scale == 0) {
    reader.Fail("scale must be a number other than 0, negative for little-endian floats");
  }
  return scale;
}

Header ReadHeader(ByteReader& reader) {
  Header header;
  header.channels = reader.Take(2, "the magic number")[1] == 'F' ? 3 : 1;
  reader.OneSpace();
  const int width = reader.WholeNumber("width", 1, std::numeric_limits<int>::max());
  const int height = reader.WholeNumber("height", 1, std::numeric_limits<int>::max());
  header.size = CheckedSize("PFM", width, height);
  const double scale = ReadScale(reader);
  header.scale = std::abs(scale);
  header.is_little_endian = scale < 0;
  reader.SpaceBefore(header.PixelBytes());
  return header;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("PFM", bytes);
  return ReadHeader(reader).size;
}

double ReadFloat(ByteReader& reader, const Header& header) {
  return std::bit_cast<float>(header.is_little_endian ? reader.Little32("a pixel") : reader.Big32("a pixel"));
}

Color ReadPixel(ByteReader& reader, const Header& header) {
  const double r = ReadFloat(reader, header);
  if (header.channels == 1) return {r, r, r};
  const double g = ReadFloat(reader, header);
  const double b = ReadFloat(reader, header);
  return {r, g, b};
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("PFM", bytes);
  const Header header = ReadHeader(reader);
  reader.Need(header.PixelBytes(), "the image");
  DecodedImage decoded{Image(header.size.width, header.size.height)};
  Image& image = decoded.image;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, ReadPixel(reader, header));
  // A unit of light, on which programs do not agree.
  if (header.scale != 1) decoded.warnings.push_back("PFM states a scale other than 1, which is not applied");
  WarnOfBytesBehind(decoded, "PFM", reader.Left());
  return decoded;
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding&, const ImageSettings&) {
  const std::string header = "PF\n" + std::to_string(image.Width()) + " " + std::to_string(image.Height()) + "\n-1.0\n";
  std::vector<unsigned char> bytes(header.begin(), header.end());
  bytes.reserve(bytes.size() + 4 * image.Channels().size());
  for (float channel : image.Channels()) {
    const auto bits = std::bit_cast<std::uint32_t>(channel);
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(bits >> shift));
  }
  return bytes;
}

}  // namespace
}  // namespace pfm

extern const ImageFormat pfm_format{"pfm", {"pfm"}, pfm::Recognizes, pfm::ReadSize, pfm::Decode, pfm::Encode, true};

}  // namespace R2
