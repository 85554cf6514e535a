#include <limits>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Netpbm's images: P3 and P6 in color, P2 and P5 in gray, P1 and P4 in black and white; the lower numbers are text, the
// higher ones binary. Written as P6.
// source: Poskanzer, ppm(5), pgm(5) and pbm(5), netpbm.sourceforge.net/doc/ppm.html
namespace R2 {

namespace ppm {
namespace {

struct Header {
  bool is_text = false, is_bits = false;  // with bits, 1 is black
  int channels = 3;
  ImageSize size;
  int largest = 255;  // the sample value that means 1

  int BytesPerSample() const { return largest > 255 ? 2 : 1; }
  std::uint64_t Samples() const {
    return std::uint64_t{1} * static_cast<unsigned>(channels) * static_cast<unsigned>(size.width) *
           static_cast<unsigned>(size.height);
  }
  /// Returns the bytes per row of bits; rows start at whole bytes.
  std::uint64_t RowOfBits() const { return (static_cast<std::uint64_t>(size.width) + 7) / 8; }
  std::uint64_t BinaryBytes() const {
    return is_bits ? RowOfBits() * static_cast<unsigned>(size.height)
                   : Samples() * static_cast<unsigned>(BytesPerSample());
  }
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6';
}

Header ReadHeader(ByteReader& reader) {
  const int digit = reader.Take(2, "the magic number")[1] - '0';
  reader.OneSpace();
  Header header;
  header.is_text = digit <= 3;
  header.is_bits = digit == 1 || digit == 4;
  header.channels = digit == 3 || digit == 6 ? 3 : 1;
  const int width = reader.WholeNumber("width", 1, std::numeric_limits<int>::max());
  const int height = reader.WholeNumber("height", 1, std::numeric_limits<int>::max());
  header.size = CheckedSize("PPM", width, height);
  header.largest = header.is_bits ? 1 : reader.WholeNumber("the largest value", 1, 65535);
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
  if (sample > header.largest) reader.Fail("contains a pixel value above " + std::to_string(header.largest));
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

/// Reads one row of bits, where 1 is black. In text, white space between them is optional.
void ReadRowOfBits(ByteReader& reader, const Header& header, Image& image, int y) {
  const auto set = [&](int x, bool is_black) { image.Set(x, y, is_black ? Color{} : Color{1, 1, 1}); };
  if (header.is_text) {
    for (int x = 0; x < image.Width(); ++x) set(x, reader.Bit("a pixel"));
    return;
  }
  const auto row = reader.Take(header.RowOfBits(), "a row");
  for (int x = 0; x < image.Width(); ++x) set(x, row[static_cast<std::size_t>(x) / 8] >> (7 - x % 8) & 1);
}

void ReadRow(ByteReader& reader, const Header& header, Image& image, int y) {
  if (header.is_bits) return ReadRowOfBits(reader, header, image, y);
  for (int x = 0; x < image.Width(); ++x) image.Set(x, y, ReadPixel(reader, header));
}

/// Warns about further images, since several may follow each other in one file.
void WarnOfRest(DecodedImage& decoded, ByteReader& reader, bool is_text) {
  if (is_text) reader.SkipSpace();
  if (reader.Left() == 0) return;
  if (Recognizes(reader.Rest()))
    decoded.warnings.push_back("PPM contains further images after the first, which are ignored");
  else
    WarnOfBytesBehind(decoded, "PPM", reader.Left());
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("PPM", bytes);
  const Header header = ReadHeader(reader);
  if (!header.is_text) reader.SpaceBefore(header.BinaryBytes());
  // In text, a sample takes at least one digit, preceded by white space unless it is a bit.
  const std::uint64_t bytes_of_text = header.Samples() * (header.is_bits ? 1 : 2);
  reader.Need(header.is_text ? bytes_of_text : header.BinaryBytes(), "the image");
  DecodedImage decoded{Image(header.size.width, header.size.height)};
  for (int y = header.size.height - 1; y >= 0; --y) ReadRow(reader, header, decoded.image, y);
  WarnOfRest(decoded, reader, header.is_text);
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

extern const ImageFormat ppm_format{"ppm",       {"ppm", "pnm"}, ppm::Recognizes, ppm::ReadSize, ppm::Decode,
                                    ppm::Encode, false};

}  // namespace R2
