#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "R1/Elementary.h"
#include "R2/image_files/ByteReader.h"
#include "R2/image_files/Orientation.h"
#include "R2/image_files/formats.h"

// Radiance images: linear light, three mantissas of 8 bits and the exponent of the largest, run-length encoded.
// source: Ward, Real Pixels (1991), Graphics Gems II, ch. II.5; Ward, Radiance File Formats, "Picture File Format", for
//         the header; Radiance's src/common/color.c for the two run-length encodings. A mantissa m means m/256 exactly,
//         as in most readers today; Radiance itself adds half a step, because it truncates when it writes, where we
//         round.
namespace R2 {

namespace hdr {
namespace {

using Pixel = std::array<unsigned char, 4>;  // mantissas of r g b, exponent + 128

// The widths that the newer run-length encoding supports.
constexpr int least_encoded_width = 8, most_encoded_width = 32767;

bool CanBeEncoded(int width) { return width >= least_encoded_width && width <= most_encoded_width; }

Color FromPixel(const Pixel& pixel) {
  if (pixel[3] == 0) return {};
  const double step = std::ldexp(1.0, pixel[3] - (128 + 8));
  return {pixel[0] * step, pixel[1] * step, pixel[2] * step};
}

/// Clamps a channel to the format's range: at least 0 (NaN becomes 0 too), at most the largest exponent.
double Storable(double channel) {
  const double largest = std::ldexp(255.0, 255 - (128 + 8));
  return channel > 0 ? std::min(channel, largest) : 0;
}

/// Encodes a color. Accuracy: each channel within half a step, 1/256 of the largest channel. Below 2^-128 all is black.
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

/// The relevant parts of the header.
struct Header {
  ImageSize stored;  // the width is that of a scan line
  Orientation orientation;
  ImageSettings settings;  // lines of "name=value"; the last one of each name
  // The products of the factors on all lines of a name.
  double exposure = 1, pixel_aspect = 1;
  std::array<double, 3> color_correction{1, 1, 1};
  bool has_other_primaries = false;
};

/// Reads a line without its end, which is CR LF if a writer on Windows used text mode.
std::string_view ReadLine(ByteReader& reader, const char* what) {
  std::string_view line = reader.Until('\n', what);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Returns the numbers of a text, separated by blanks: up to `count` of them, up to the first that is not a number.
std::vector<double> Numbers(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) break;
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return numbers;
}

/// Returns the factor on a line; 1 if the line contains no valid factor.
double Factor(std::string_view value) {
  const std::vector<double> numbers = Numbers(value, 1);
  return !numbers.empty() && numbers[0] > 0 && std::isfinite(numbers[0]) ? numbers[0] : 1;
}

/// Returns true if chromaticities are neither those of Radiance, which images without the entry have, nor those of
/// sRGB.
bool AreOtherPrimaries(std::string_view value) {
  using Chromaticities = std::array<double, 8>;  // x and y of red, green, blue and white
  constexpr Chromaticities radiance{0.64, 0.33, 0.29, 0.6, 0.15, 0.06, 1 / 3.0, 1 / 3.0};
  constexpr Chromaticities srgb{0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329};
  constexpr double rounding = 0.0006;  // of the three digits that files contain
  const std::vector<double> stated = Numbers(value, radiance.size());
  const auto is_near = [](double a, double b) { return std::abs(a - b) < rounding; };
  return std::ranges::none_of(std::array{radiance, srgb}, [&](const Chromaticities& known) {
    return std::equal(stated.begin(), stated.end(), known.begin(), known.end(), is_near);
  });
}

void ReadVariable(const ByteReader& reader, Header& header, std::string_view name, std::string_view value) {
  if (name == "FORMAT") {
    if (value != "32-bit_rle_rgbe") reader.Fail("has a pixel format other than 32-bit_rle_rgbe");
    return;
  }
  if (name == "EXPOSURE") header.exposure *= Factor(value);
  if (name == "PIXASPECT") header.pixel_aspect *= Factor(value);
  if (name == "PRIMARIES") header.has_other_primaries = AreOtherPrimaries(value);
  if (name == "COLORCORR") {
    const std::vector<double> factors = Numbers(value, 3);
    for (std::size_t i = 0; i < factors.size(); ++i) header.color_correction[i] *= factors[i];
  }
  header.settings.insert_or_assign(std::string(name), std::string(value));
}

/// "+X" or "-Y" and a length.
struct Axis {
  bool is_x = false, is_rising = false;  // x to the right, y upwards
  int length = 0;
};

Axis ReadAxis(const ByteReader& reader, std::string_view sign_and_name, std::string_view length) {
  Axis axis;
  if (sign_and_name.size() != 2 || (sign_and_name[0] != '+' && sign_and_name[0] != '-') ||
      (sign_and_name[1] != 'X' && sign_and_name[1] != 'Y'))
    reader.Fail("has a resolution other than '-Y height +X width' with any signs and in any order");
  axis.is_x = sign_and_name[1] == 'X';
  axis.is_rising = sign_and_name[0] == '+';
  const auto [end, error] = std::from_chars(length.data(), length.data() + length.size(), axis.length);
  if (error != std::errc() || end != length.data() + length.size())
    reader.Fail("width or height is not a whole number");
  return axis;
}

/// Reads the resolution, usually "-Y 480 +X 640": 480 scan lines from the top down, of 640 pixels from left to right.
void ReadResolution(ByteReader& reader, Header& header) {
  std::string_view line = ReadLine(reader, "the resolution");
  std::array<std::string_view, 4> words;
  for (std::string_view& word : words) {
    word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(word.size() + 1, line.size()));
  }
  const Axis slow = ReadAxis(reader, words[0], words[1]), fast = ReadAxis(reader, words[2], words[3]);
  if (slow.is_x == fast.is_x || !line.empty()) reader.Fail("has a resolution that does not state X and Y once each");
  const Axis& x = slow.is_x ? slow : fast;
  const Axis& y = slow.is_x ? fast : slow;
  header.orientation = {slow.is_x, !x.is_rising, y.is_rising};
  header.stored = CheckedSize("HDR", fast.length, slow.length);
}

/// Reads lines of "name=value" up to an empty one, then the resolution.
Header ReadHeader(ByteReader& reader) {
  Header header;
  ReadLine(reader, "the first line");
  for (std::string_view line; !(line = ReadLine(reader, "the header")).empty();) {
    const auto equals = line.find('=');
    if (line.starts_with('#') || equals == std::string_view::npos) continue;
    ReadVariable(reader, header, line.substr(0, equals), line.substr(equals + 1));
  }
  ReadResolution(reader, header);
  return header;
}

/// Formats a number in up to six digits for messages.
std::string Text(double number) {
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6).ptr};
}

/// Returns warnings about entries of the header that affect the values. The values themselves stay as stored, as in all
/// readers of textures.
std::vector<std::string> Warnings(const Header& header) {
  std::vector<std::string> warnings;
  if (header.exposure != 1)
    warnings.push_back("HDR states that its values have been multiplied by an EXPOSURE of " + Text(header.exposure) +
                       ", which is not undone; rayimg convert -exposure " +
                       Text(-R1::Log(header.exposure) / R1::Log(2)) + " undoes it");
  const auto& [r, g, b] = header.color_correction;
  if (r != 1 || g != 1 || b != 1)
    warnings.push_back("HDR states a COLORCORR of " + Text(r) + " " + Text(g) + " " + Text(b) +
                       ", which is not undone");
  if (header.pixel_aspect != 1)
    warnings.push_back("HDR states pixels that are not square, a PIXASPECT of " + Text(header.pixel_aspect) +
                       "; they are taken as square");
  if (header.has_other_primaries) warnings.push_back("HDR states PRIMARIES of its own, which are taken as sRGB's");
  return warnings;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("HDR", bytes);
  const Header header = ReadHeader(reader);
  return Turned(header.stored, header.orientation);
}

Pixel ReadPixel(ByteReader& reader) {
  const auto b = reader.Take(4, "a pixel");
  return {b[0], b[1], b[2], b[3]};
}

/// Reads plain pixels, starting with `first`. One with mantissas 1 1 1 repeats the pixel before it; several of them in
/// a row are the bytes of a longer count.
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

/// Reads the four bytes of all pixels in turn, each as runs (count + 128, value) and stretches (count, values).
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
  if ((first[2] << 8 | first[3]) != width) reader.Fail("is damaged: a row has another width than the image");
  return ReadEncodedRow(reader, static_cast<std::size_t>(width));
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  ByteReader reader("HDR", bytes);
  Header header = ReadHeader(reader);
  const ImageSize size = header.stored;
  // A run may stand for many pixels, but no row takes less than one pixel's bytes. The image is allocated only after
  // its first row was read, so that wide ones have proven their bytes too.
  reader.Need(std::uint64_t{4} * static_cast<unsigned>(size.height), "the image");
  Image image;
  for (int y = size.height - 1; y >= 0; --y) {
    const std::vector<Pixel> row = ReadRow(reader, size.width);
    if (image.Width() == 0) image = Image(size.width, size.height);
    for (int x = 0; x < size.width; ++x) image.Set(x, y, FromPixel(row[static_cast<std::size_t>(x)]));
  }
  DecodedImage decoded{std::move(image)};
  Turn(decoded, header.orientation);
  decoded.settings = std::move(header.settings);
  decoded.warnings = Warnings(header);
  WarnOfBytesBehind(decoded, "HDR", reader.Left());
  return decoded;
}

/// Returns the number of equal bytes from `x` on, at most 127.
std::size_t RunLength(std::span<const unsigned char> bytes, std::size_t x) {
  std::size_t end = x + 1;
  while (end < bytes.size() && end - x < 127 && bytes[end] == bytes[x]) ++end;
  return end - x;
}

void AppendRuns(std::vector<unsigned char>& out, std::span<const unsigned char> bytes) {
  constexpr std::size_t worthwhile = 4;  // a shorter run that splits a stretch costs as much as it saves
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
    // Plain pixels. None looks like a run, since the largest mantissa of a color is at least 128.
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

extern const ImageFormat hdr_format{
    "hdr", {"hdr", "rgbe", "pic"}, hdr::Recognizes, hdr::ReadSize, hdr::Decode, hdr::Encode, true};

}  // namespace R2
