#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// Radiance pictures: linear light, three mantissas of 8 bits and the exponent of the largest, run-length encoded.
// source: Ward, Real Pixels (1991), Graphics Gems II, ch. II.5; Radiance's src/common/color.c for the two run-length
//         encodings. A mantissa m means m/256 exactly, as in most readers today; Radiance itself adds half a step,
//         because it cuts off when it writes, where we round.
namespace R2 {

namespace hdr {
namespace {

using Pixel = std::array<unsigned char, 4>;  // mantissas of r g b, exponent + 128

// The newer run-length encoding knows only these widths.
constexpr int least_encoded_width = 8, most_encoded_width = 32767;

bool CanBeEncoded(int width) { return width >= least_encoded_width && width <= most_encoded_width; }

Color FromPixel(const Pixel& pixel) {
  if (pixel[3] == 0) return {};
  const double step = std::ldexp(1.0, pixel[3] - (128 + 8));
  return {pixel[0] * step, pixel[1] * step, pixel[2] * step};
}

/// What the kind can hold: nothing below zero (NaN becomes zero too), nothing beyond the largest exponent.
double Storable(double channel) {
  const double largest = std::ldexp(255.0, 255 - (128 + 8));
  return channel > 0 ? std::min(channel, largest) : 0;
}

/// Accuracy: each channel within half a step, 1/256 of the largest channel. Below 2^-128 all is black.
Pixel ToPixel(const Color& color) {
  const double r = Storable(color.r), g = Storable(color.g), b = Storable(color.b);
  const double largest = std::max({r, g, b});
  int exponent = 0;
  const double mantissa = std::frexp(largest, &exponent);
  if (mantissa * 256 >= 255.5) ++exponent;  // would round up to 256
  if (largest == 0 || exponent < -127) return {};
  const auto rounded = [&](double channel) {
    return static_cast<unsigned char>(std::ldexp(channel, 8 - exponent) + 0.5);
  };
  return {rounded(r), rounded(g), rounded(b), static_cast<unsigned char>(exponent + 128)};
}

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 2 && bytes[0] == '#' && bytes[1] == '?';
}

int Side(const ByteReader& reader, std::string_view word) {
  int side = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), side);
  if (error != std::errc() || end != word.data() + word.size()) reader.Fail("width or height is not a whole number");
  return side;
}

/// "-Y 480 +X 640": rows from the top, pixels from the left.
ImageSize ReadResolution(ByteReader& reader) {
  std::string_view line = reader.Until('\n', "the resolution");
  constexpr std::string_view before_height = "-Y ", before_width = " +X ";
  const auto middle = line.find(before_width);
  if (!line.starts_with(before_height) || middle == std::string_view::npos || middle < before_height.size()) {
    reader.Fail("has an orientation other than -Y height +X width, the only one that is read");
  }
  const int height = Side(reader, line.substr(before_height.size(), middle - before_height.size()));
  const int width = Side(reader, line.substr(middle + before_width.size()));
  return CheckedSize("HDR", width, height);
}

/// Lines of "name=value" up to an empty one, then the resolution. Pixel values are given as they are stored; an
/// EXPOSURE the file may name is among the settings, for whoever wants to divide by it.
ImageSize ReadHeader(ByteReader& reader, ImageSettings* settings) {
  reader.Until('\n', "the first line");
  for (std::string_view line; !(line = reader.Until('\n', "the header")).empty();) {
    const auto equals = line.find('=');
    if (line.starts_with('#') || equals == std::string_view::npos) continue;
    const std::string_view name = line.substr(0, equals), value = line.substr(equals + 1);
    if (name == "FORMAT") {
      if (value != "32-bit_rle_rgbe") reader.Fail("has a pixel format other than 32-bit_rle_rgbe");
    } else if (settings) {
      settings->insert_or_assign(std::string(name), std::string(value));
    }
  }
  return ReadResolution(reader);
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("HDR", bytes);
  return ReadHeader(reader, nullptr);
}

Pixel ReadPixel(ByteReader& reader) {
  const auto b = reader.Take(4, "a pixel");
  return {b[0], b[1], b[2], b[3]};
}

/// Plain pixels from `first` on; one with mantissas 1 1 1 repeats the pixel before it, and several of them in a row
/// are the bytes of a longer count.
std::vector<Pixel> ReadOldRow(ByteReader& reader, Pixel first, std::size_t width) {
  std::vector<Pixel> row;
  int shift = 0;
  for (Pixel pixel = first;; pixel = ReadPixel(reader)) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      if (row.empty() || shift > 24) reader.Fail("is damaged: a run without a pixel to repeat, or beyond all bounds");
      const std::uint64_t count = std::uint64_t{pixel[3]} << shift;
      if (count > width - row.size()) reader.Fail("is damaged: a run goes beyond its row");
      row.insert(row.end(), static_cast<std::size_t>(count), Pixel(row.back()));
      shift += 8;
    } else {
      row.push_back(pixel);
      shift = 0;
    }
    if (row.size() == width) return row;
  }
}

/// The four bytes of all pixels one after another, each as runs (count + 128, value) and stretches (count, values).
std::vector<Pixel> ReadEncodedRow(ByteReader& reader, std::size_t width) {
  std::vector<Pixel> row(width);
  for (std::size_t part = 0; part < 4; ++part) {
    for (std::size_t x = 0; x < width;) {
      const unsigned code = reader.Byte("a run");
      const bool is_run = code > 128;
      const unsigned count = is_run ? code - 128 : code;
      if (count == 0 || count > width - x) reader.Fail("is damaged: a run is empty or goes beyond its row");
      const auto values = reader.Take(is_run ? 1 : count, "a run");
      for (unsigned i = 0; i < count; ++i) row[x++][part] = values[is_run ? 0 : i];
    }
  }
  return row;
}

std::vector<Pixel> ReadRow(ByteReader& reader, int width) {
  const Pixel first = ReadPixel(reader);
  const bool is_encoded = CanBeEncoded(width) && first[0] == 2 && first[1] == 2 && first[2] < 128;
  if (!is_encoded) return ReadOldRow(reader, first, static_cast<std::size_t>(width));
  if ((first[2] << 8 | first[3]) != width) reader.Fail("is damaged: a row has another width than the picture");
  return ReadEncodedRow(reader, static_cast<std::size_t>(width));
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("HDR", bytes);
  DecodedImage decoded;
  const ImageSize size = ReadHeader(reader, &decoded.settings);
  // A run may stand for many pixels, yet no row takes less than one pixel's bytes. The picture is asked for only
  // once its first row is there, so that wide ones have shown their bytes too.
  reader.Need(std::uint64_t{4} * static_cast<unsigned>(size.height), "the picture");
  Image& image = decoded.image;
  for (int y = size.height - 1; y >= 0; --y) {
    const std::vector<Pixel> row = ReadRow(reader, size.width);
    if (image.Width() == 0) image = Image(size.width, size.height);
    for (int x = 0; x < size.width; ++x) image.Set(x, y, FromPixel(row[static_cast<std::size_t>(x)]));
  }
  return decoded;
}

/// How many equal bytes start at `x`, 127 at most.
std::size_t RunLength(std::span<const unsigned char> bytes, std::size_t x) {
  std::size_t end = x + 1;
  while (end < bytes.size() && end - x < 127 && bytes[end] == bytes[x]) ++end;
  return end - x;
}

void AppendRuns(std::vector<unsigned char>& out, std::span<const unsigned char> bytes) {
  constexpr std::size_t worthwhile = 4;  // a shorter run costs as much as it saves when it cuts a stretch in two
  for (std::size_t x = 0; x < bytes.size();) {
    const std::size_t run = RunLength(bytes, x);
    if (run >= worthwhile) {
      out.push_back(static_cast<unsigned char>(128 + run));
      out.push_back(bytes[x]);
      x += run;
      continue;
    }
    std::size_t end = x;
    while (end < bytes.size() && end - x < 128 && RunLength(bytes, end) < worthwhile) ++end;
    out.push_back(static_cast<unsigned char>(end - x));
    out.insert(out.end(), bytes.begin() + static_cast<std::ptrdiff_t>(x),
               bytes.begin() + static_cast<std::ptrdiff_t>(end));
    x = end;
  }
}

void AppendRow(std::vector<unsigned char>& out, const std::vector<Pixel>& row) {
  const int width = static_cast<int>(row.size());
  if (!CanBeEncoded(width)) {
    // Plain pixels. None looks like a run: the largest mantissa of a color is at least 128.
    for (const Pixel& pixel : row) out.insert(out.end(), pixel.begin(), pixel.end());
    return;
  }
  out.insert(out.end(), {2, 2, static_cast<unsigned char>(width >> 8), static_cast<unsigned char>(width & 255)});
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<unsigned char> bytes;
    bytes.reserve(row.size());
    for (const Pixel& pixel : row) bytes.push_back(pixel[part]);
    AppendRuns(out, bytes);
  }
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding&, const ImageSettings&) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.Height()) + " +X " +
                             std::to_string(image.Width()) + "\n";
  std::vector<unsigned char> bytes(header.begin(), header.end());
  for (int y = image.Height() - 1; y >= 0; --y) {
    std::vector<Pixel> row;
    row.reserve(static_cast<std::size_t>(image.Width()));
    for (int x = 0; x < image.Width(); ++x) row.push_back(ToPixel(image.At(x, y)));
    AppendRow(bytes, row);
  }
  return bytes;
}

}  // namespace
}  // namespace hdr

const ImageFormat hdr_format{"hdr", {"hdr", "rgbe", "pic"}, hdr::Recognizes, hdr::ReadSize, hdr::Decode, hdr::Encode,
                             true};

}  // namespace R2
