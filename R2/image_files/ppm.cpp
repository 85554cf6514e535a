#include <limits>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Netpbm's pixmaps: P3 and P6 in color, P2 and P5 in gray; 3 and 2 are text, 6 and 5 binary. Written as P6.
// source: Poskanzer, ppm(5) and pgm(5), netpbm.sourceforge.net/doc/ppm.html
namespace R2 {

namespace ppm {
namespace {

struct Header {
  bool is_text = false;
  int channels = 3;
  ImageSize size;
  int largest = 255;  // the sample that means 1

  int BytesPerSample() const { return largest > 255 ? 2 : 1; }
  std::uint64_t Samples() const {
    return std::uint64_t{1} * static_cast<unsigned>(channels) * static_cast<unsigned>(size.width) *
           static_cast<unsigned>(size.height);
  }
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == 'P' &&
         (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6');
}

Header ReadHeader(ByteReader& reader) {
  const int digit = reader.Take(2, "the magic number")[1] - '0';
  reader.OneSpace();
  Header header;
  header.is_text = digit == 2 || digit == 3;
  header.channels = digit == 2 || digit == 5 ? 1 : 3;
  const int width = reader.WholeNumber("width", 1, std::numeric_limits<int>::max());
  const int height = reader.WholeNumber("height", 1, std::numeric_limits<int>::max());
  header.size = CheckedSize("PPM", width, height);
  header.largest = reader.WholeNumber("the largest value", 1, 65535);
  return header;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("PPM", bytes);
  return ReadHeader(reader).size;
}

int ReadSample(ByteReader& reader, const Header& header) {
  if (header.is_text) return reader.WholeNumber("a pixel value", 0, header.largest);
  int sample = reader.Byte("a pixel");
  if (header.BytesPerSample() == 2) sample = sample << 8 | reader.Byte("a pixel");
  if (sample > header.largest) reader.Fail("holds a pixel value above " + std::to_string(header.largest));
  return sample;
}

Color ReadPixel(ByteReader& reader, const Header& header) {
  const double largest = header.largest;
  const double r = ReadSample(reader, header) / largest;
  if (header.channels == 1) return {r, r, r};
  const double g = ReadSample(reader, header) / largest;
  const double b = ReadSample(reader, header) / largest;
  return {r, g, b};
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("PPM", bytes);
  const Header header = ReadHeader(reader);
  if (!header.is_text) reader.OneSpace();
  // In text, a sample takes a digit at least and all have white space before them.
  const auto bytes_per_sample = header.is_text ? 2u : static_cast<unsigned>(header.BytesPerSample());
  reader.Need(header.Samples() * bytes_per_sample, "the picture");
  DecodedImage decoded{Image(header.size.width, header.size.height)};
  Image& image = decoded.image;
  for (int y = image.Height() - 1; y >= 0; --y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, ReadPixel(reader, header));
  return decoded;
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding& encoding, const ImageSettings&) {
  const std::string header = "P6\n" + std::to_string(image.Width()) + " " + std::to_string(image.Height()) + "\n255\n";
  std::vector<unsigned char> bytes(header.begin(), header.end());
  bytes.reserve(bytes.size() + image.Channels().size());
  for (int y = image.Height() - 1; y >= 0; --y) {
    const auto row = ByteRow(image, y, encoding);
    bytes.insert(bytes.end(), row.begin(), row.end());
  }
  return bytes;
}

}  // namespace
}  // namespace ppm

const ImageFormat ppm_format{"ppm", {"ppm", "pnm"}, ppm::Recognizes, ppm::ReadSize, ppm::Decode, ppm::Encode, false};

}  // namespace R2
