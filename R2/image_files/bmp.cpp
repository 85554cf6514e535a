#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Windows bitmaps, uncompressed. Written with 24 bits per pixel, bottom row first, as most programs expect.
// source: Microsoft, "BITMAPINFOHEADER" and "BITMAPV5HEADER", Win32 reference
namespace R2 {

namespace bmp {
namespace {

constexpr int file_header_size = 14;
constexpr int info_header_size = 40;

struct Header {
  std::uint32_t pixels_offset = 0;
  std::uint32_t info_size = 0;
  ImageSize size;
  bool is_top_down = false;
  int bits = 24;  // per pixel: 8 with a palette, 24, 32
  std::uint32_t palette_size = 0;

  std::uint64_t RowBytes() const {
    return std::uint64_t{1} * static_cast<unsigned>(size.width) * static_cast<unsigned>(bits / 8);
  }
  /// Rows start at multiples of four bytes.
  std::uint64_t RowStride() const { return (RowBytes() + 3) / 4 * 4; }
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == 'B' && bytes[1] == 'M';
}

/// Bit fields are read only where they say what a plain 32-bit pixel has anyway: blue, green, red, unused or alpha.
void CheckBitFields(ByteReader& reader) {
  const std::uint32_t red = reader.Little32("the bit fields");
  const std::uint32_t green = reader.Little32("the bit fields");
  const std::uint32_t blue = reader.Little32("the bit fields");
  if (red != 0xff0000 || green != 0xff00 || blue != 0xff)
    reader.Fail("has bit fields other than 8-bit blue, green, red");
}

Header ReadHeader(ByteReader& reader) {
  Header header;
  reader.Take(10, "the file header");
  header.pixels_offset = reader.Little32("the file header");
  header.info_size = reader.Little32("the info header");
  if (header.info_size < info_header_size) reader.Fail("has a header of an unknown kind");
  const std::int64_t width = reader.LittleSigned32("the width");
  const std::int64_t height = reader.LittleSigned32("the height");
  header.size = CheckedSize("BMP", width, height < 0 ? -height : height);
  header.is_top_down = height < 0;
  reader.Little16("the planes");
  header.bits = reader.Little16("the bits per pixel");
  const std::uint32_t compression = reader.Little32("the compression");
  reader.Take(12, "the info header");
  header.palette_size = reader.Little32("the palette size");
  reader.Take(4, "the info header");

  if (header.bits != 8 && header.bits != 24 && header.bits != 32) {
    reader.Fail("has " + std::to_string(header.bits) + " bits per pixel; 8, 24 and 32 are read");
  }
  const bool has_bit_fields = compression == 3 && header.bits == 32;
  if (has_bit_fields) CheckBitFields(reader);
  if (compression != 0 && !has_bit_fields) reader.Fail("is compressed; only uncompressed ones are read");
  if (header.palette_size > 256) reader.Fail("has a palette of more than 256 colors");
  if (header.palette_size == 0) header.palette_size = 256;
  return header;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("BMP", bytes);
  return ReadHeader(reader).size;
}

/// The palette, 4 bytes a color, behind the headers.
std::span<const unsigned char> ReadPalette(std::span<const unsigned char> bytes, const Header& header) {
  ByteReader reader("BMP", bytes);
  reader.Take(std::uint64_t{file_header_size} + header.info_size, "the header");
  return reader.Take(std::uint64_t{4} * header.palette_size, "the palette");
}

Color FromBlueGreenRed(std::span<const unsigned char> b) { return {b[2] / 255.0, b[1] / 255.0, b[0] / 255.0}; }

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("BMP", bytes);
  const Header header = ReadHeader(reader);
  const auto palette = header.bits == 8 ? ReadPalette(bytes, header) : std::span<const unsigned char>{};

  ByteReader pixels("BMP", bytes);
  pixels.Take(header.pixels_offset, "what comes before the pixels");
  // The last row may lack the bytes that only fill it up.
  const auto height = static_cast<std::uint64_t>(header.size.height);
  const auto raster = pixels.Take(header.RowStride() * (height - 1) + header.RowBytes(), "the picture");

  DecodedImage decoded{Image(header.size.width, header.size.height)};
  Image& image = decoded.image;
  const auto pixel_size = static_cast<std::size_t>(header.bits / 8);
  for (int row = 0; row < image.Height(); ++row) {
    const int y = header.is_top_down ? image.Height() - 1 - row : row;
    const auto line = raster.subspan(static_cast<std::size_t>(row) * header.RowStride(), header.RowBytes());
    for (int x = 0; x < image.Width(); ++x) {
      // The fourth byte of a 32-bit pixel is unused or alpha; a picture here has no alpha, so it is dropped.
      auto pixel = line.subspan(static_cast<std::size_t>(x) * pixel_size, pixel_size);
      if (header.bits == 8) {
        if (pixel[0] >= header.palette_size) reader.Fail("has a pixel that is not in its palette");
        pixel = palette.subspan(std::size_t{4} * pixel[0], 4);
      }
      image.Set(x, y, FromBlueGreenRed(pixel));
    }
  }
  return decoded;
}

void AppendLittle(std::vector<unsigned char>& bytes, std::uint32_t number, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(number >> 8 * i));
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding& encoding, const ImageSettings&) {
  Header header;
  header.size = {image.Width(), image.Height()};
  // With the filling of its row a pixel takes at most 4 bytes, and max_pixels of them far less than the 2^32 bytes
  // that the header can name.
  const auto raster_size = static_cast<std::uint32_t>(header.RowStride() * static_cast<std::uint64_t>(image.Height()));
  constexpr std::uint32_t pixels_offset = file_header_size + info_header_size;
  constexpr std::uint32_t dots_per_metre = 2835;  // 72 an inch; readers want a number, nobody looks at it

  std::vector<unsigned char> bytes{'B', 'M'};
  bytes.reserve(pixels_offset + raster_size);
  AppendLittle(bytes, pixels_offset + raster_size, 4);
  AppendLittle(bytes, 0, 4);  // reserved
  AppendLittle(bytes, pixels_offset, 4);
  AppendLittle(bytes, info_header_size, 4);
  AppendLittle(bytes, static_cast<std::uint32_t>(image.Width()), 4);
  AppendLittle(bytes, static_cast<std::uint32_t>(image.Height()), 4);
  AppendLittle(bytes, 1, 2);  // planes
  AppendLittle(bytes, 24, 2);
  AppendLittle(bytes, 0, 4);  // not compressed
  AppendLittle(bytes, raster_size, 4);
  AppendLittle(bytes, dots_per_metre, 4);
  AppendLittle(bytes, dots_per_metre, 4);
  AppendLittle(bytes, 0, 4);  // no palette
  AppendLittle(bytes, 0, 4);  // every color matters

  for (int y = 0; y < image.Height(); ++y) {
    const auto row = ByteRow(image, y, encoding);
    for (std::size_t i = 0; i < row.size(); i += 3) bytes.insert(bytes.end(), {row[i + 2], row[i + 1], row[i]});
    bytes.resize(bytes.size() + (header.RowStride() - header.RowBytes()));
  }
  return bytes;
}

}  // namespace
}  // namespace bmp

const ImageFormat bmp_format{"bmp", {"bmp"}, bmp::Recognizes, bmp::ReadSize, bmp::Decode, bmp::Encode, false};

}  // namespace R2
