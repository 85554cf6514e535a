#include <algorithm>

#include "R2/image_files/BmpHeader.h"
#include "R2/image_files/BmpRunLength.h"
#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Bitmaps of Windows and OS/2, with palettes, bit fields and run lengths. Written with 24 bits per pixel, bottom row
// first, as most programs expect.
// source: see BmpHeader.h and BmpRunLength.h
namespace R2 {

namespace bmp {
namespace {

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == 'B' && bytes[1] == 'M';
}

ImageSize ReadSize(std::span<const unsigned char> bytes) { return ReadHeader(bytes).size; }

Color FromBlueGreenRed(std::span<const unsigned char> b) { return {b[2] / 255.0, b[1] / 255.0, b[0] / 255.0}; }

/// Returns the palette as colors.
std::vector<Color> ColorsOf(const Header& header) {
  std::vector<Color> colors;
  for (auto rest = header.palette; !rest.empty(); rest = rest.subspan(header.palette_entry))
    colors.push_back(FromBlueGreenRed(rest));
  return colors;
}

/// Returns the image row of a row in the file.
int ImageRow(const Header& header, int row) { return header.is_top_down ? header.size.height - 1 - row : row; }

const Color& ColorAt(const std::vector<Color>& colors, unsigned place) {
  if (place >= colors.size()) throw ImageError("BMP has a pixel that is not in its palette");
  return colors[place];
}

/// Returns the `bits`-bit number, 1 to 8 bits, at `x`; the first is in the highest bits.
unsigned PlaceAt(std::span<const unsigned char> row, int x, int bits) {
  const std::size_t bit = static_cast<std::size_t>(x) * static_cast<std::size_t>(bits);
  const int shift = 8 - bits - static_cast<int>(bit % 8);
  return static_cast<unsigned>(row[bit / 8] >> shift) & ((1u << bits) - 1);
}

/// The range of the alpha values seen so far.
struct AlphaRange {
  double least = 1, most = 0;
  void Add(double alpha) {
    least = std::min(least, alpha);
    most = std::max(most, alpha);
  }
  /// Returns true if alpha is meant: writers that do not know alpha set all of it to zero.
  bool IsTransparent() const { return least < 1 && most > 0; }
};

std::uint32_t Little(std::span<const unsigned char> bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) number |= std::uint32_t{bytes[i]} << 8 * i;
  return number;
}

void SetRowOfFields(Image& image, int y, std::span<const unsigned char> row, const Header& header, AlphaRange& alpha) {
  const auto pixel_size = static_cast<std::size_t>(header.bits / 8);
  const BitFields& fields = header.fields;
  for (int x = 0; x < image.Width(); ++x) {
    const std::uint32_t pixel = Little(row.subspan(static_cast<std::size_t>(x) * pixel_size, pixel_size));
    image.Set(x, y, {fields.red.Value(pixel), fields.green.Value(pixel), fields.blue.Value(pixel)});
    if (fields.alpha.mask != 0) alpha.Add(fields.alpha.Value(pixel));
  }
}

/// Sets a row of pixels with three or four bytes, the fourth of which is unused.
void SetRowOfBytes(Image& image, int y, std::span<const unsigned char> row, std::size_t pixel_size) {
  for (int x = 0; x < image.Width(); ++x)
    image.Set(x, y, FromBlueGreenRed(row.subspan(static_cast<std::size_t>(x) * pixel_size, pixel_size)));
}

DecodedImage DecodeRunLengths(std::span<const unsigned char> pixels, const Header& header) {
  const Places read = ReadRunLengths(pixels, header);
  const std::vector<Color> colors = ColorsOf(header);
  DecodedImage decoded{Image(header.size.width, header.size.height)};
  auto place = read.places.begin();
  for (int row = 0; row < header.size.height; ++row)
    for (int x = 0; x < header.size.width; ++x)
      decoded.image.Set(x, ImageRow(header, row), ColorAt(colors, *place++));
  decoded.warnings = read.warnings;
  WarnOfBytesBehind(decoded, "BMP", read.bytes_behind);
  return decoded;
}

DecodedImage DecodeRows(std::span<const unsigned char> pixels, const Header& header) {
  const auto height = static_cast<std::uint64_t>(header.size.height);
  const std::vector<Color> colors = ColorsOf(header);
  const bool is_bytes = header.bits == 24 || (header.bits == 32 && header.fields == BitFields{});
  DecodedImage decoded{Image(header.size.width, header.size.height)};
  Image& image = decoded.image;
  AlphaRange alpha;
  const auto stride = static_cast<std::size_t>(header.RowStride()),
             length = static_cast<std::size_t>(header.RowBytes());
  for (int row = 0; row < image.Height(); ++row) {
    const int y = ImageRow(header, row);
    const auto line = pixels.subspan(static_cast<std::size_t>(row) * stride, length);
    if (is_bytes)
      SetRowOfBytes(image, y, line, static_cast<std::size_t>(header.bits / 8));
    else if (!header.HasPalette())
      SetRowOfFields(image, y, line, header, alpha);
    else
      for (int x = 0; x < image.Width(); ++x) image.Set(x, y, ColorAt(colors, PlaceAt(line, x, header.bits)));
  }
  if (alpha.IsTransparent())
    decoded.warnings.push_back("BMP has transparent pixels: alpha is ignored, their colors count in full");
  const std::uint64_t used = header.RowStride() * height + header.profile_bytes;
  if (pixels.size() > used) WarnOfBytesBehind(decoded, "BMP", pixels.size() - used);
  return decoded;
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  const Header header = ReadHeader(bytes);
  ByteReader reader("BMP", bytes);
  reader.Take(header.pixels_start, "what comes before the pixels");
  // The last row may lack its padding.
  if (!header.is_run_length)
    reader.Need(header.RowStride() * static_cast<unsigned>(header.size.height - 1) + header.RowBytes(), "the image");
  DecodedImage decoded =
      header.is_run_length ? DecodeRunLengths(reader.Rest(), header) : DecodeRows(reader.Rest(), header);
  decoded.warnings.insert(decoded.warnings.begin(), header.warnings.begin(), header.warnings.end());
  return decoded;
}

void AppendLittle(std::vector<unsigned char>& bytes, std::uint32_t number, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(number >> 8 * i));
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding& encoding, const ImageSettings&) {
  constexpr std::uint32_t file_header_bytes = 14, info_header_bytes = 40;
  Header header;
  header.size = {image.Width(), image.Height()};
  // With padding, a pixel takes at most 4 bytes, so max_pixels of them take far less than the 2^32 bytes that the
  // header can express.
  const auto raster_size = static_cast<std::uint32_t>(header.RowStride() * static_cast<std::uint64_t>(image.Height()));
  constexpr std::uint32_t pixels_offset = file_header_bytes + info_header_bytes;
  constexpr std::uint32_t dots_per_metre = 2835;  // 72 per inch; readers expect a number but ignore it

  std::vector<unsigned char> bytes{'B', 'M'};
  bytes.reserve(pixels_offset + raster_size);
  AppendLittle(bytes, pixels_offset + raster_size, 4);
  AppendLittle(bytes, 0, 4);  // reserved
  AppendLittle(bytes, pixels_offset, 4);
  AppendLittle(bytes, info_header_bytes, 4);
  AppendLittle(bytes, static_cast<std::uint32_t>(image.Width()), 4);
  AppendLittle(bytes, static_cast<std::uint32_t>(image.Height()), 4);
  AppendLittle(bytes, 1, 2);  // planes
  AppendLittle(bytes, 24, 2);
  AppendLittle(bytes, 0, 4);  // not compressed
  AppendLittle(bytes, raster_size, 4);
  AppendLittle(bytes, dots_per_metre, 4);
  AppendLittle(bytes, dots_per_metre, 4);
  AppendLittle(bytes, 0, 4);  // no palette
  AppendLittle(bytes, 0, 4);  // all colors are important

  for (int y = 0; y < image.Height(); ++y) {
    const auto row = ByteRow(image, y, encoding);
    for (std::size_t i = 0; i < row.size(); i += 3) bytes.insert(bytes.end(), {row[i + 2], row[i + 1], row[i]});
    bytes.resize(bytes.size() + static_cast<std::size_t>(header.RowStride() - header.RowBytes()));
  }
  return bytes;
}

}  // namespace
}  // namespace bmp

extern const ImageFormat bmp_format{"bmp", {"bmp"}, bmp::Recognizes, bmp::ReadSize, bmp::Decode, bmp::Encode, false};

}  // namespace R2
