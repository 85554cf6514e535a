#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <string_view>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/ColorProfile.h"
#include "R2/image_files/Jump.h"
#include "R2/image_files/PngChunks.h"
#include "R2/image_files/TextSettings.h"
#include "R2/image_files/formats.h"

// PNG through libpng: every color type, depth and interlace mode is read, 8 and 16 bit color is written. Alpha is
// dropped with a warning, since our images have none; nothing is composited behind it. Settings are stored in text
// chunks, one per key.
// source: W3C, Portable Network Graphics (PNG) Specification, 2nd ed. (2003); libpng-manual.txt
namespace R2 {

namespace png {
namespace {

constexpr std::array<unsigned char, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

// The unpacked size limit of a chunk other than pixels, more than any command line or color profile takes, and the
// number of chunks kept: 64 MiB in total.
constexpr png_alloc_size_t most_chunk_bytes = png_alloc_size_t{1} << 20;
constexpr png_uint_32 most_chunks = 64;

// Compressing renderings takes .4 to .5 of the time of the library's default level 6, and up to 6 % more bytes; below 4
// the sizes grow faster than the time falls.
constexpr int compression_level = 4;

// Deflate expands two bits to at most 258 bytes.
constexpr std::uint64_t most_deflate_ratio = 1032;

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin());
}

/// Returns the size in the header, before the image is turned.
ImageSize ReadStoredSize(std::span<const unsigned char> bytes) {
  ByteReader reader("PNG", bytes);
  reader.Take(signature.size(), "the signature");
  reader.Take(4, "the length of the header");
  const auto name = reader.Take(4, "the header");
  if (std::memcmp(name.data(), "IHDR", 4) != 0) reader.Fail("does not start with its header");
  const std::uint32_t width = reader.Big32("the width");
  const std::uint32_t height = reader.Big32("the height");
  return CheckedSize("PNG", width, height);
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  return Turned(ReadStoredSize(bytes), PngOrientation(bytes));
}

[[noreturn]] void OnError(png_structp png, png_const_charp message) {
  static_cast<Jump*>(png_get_error_ptr(png))->Leave(message);
}

/// Ignores warnings: they are about chunks that the image does not need.
void OnWarning(png_structp, png_const_charp) {}

// --- settings ---

ImageSettings FromText(std::span<const png_text> texts) {
  ImageSettings settings;
  for (const png_text& text : texts) {
    const bool is_utf8 = text.compression == PNG_ITXT_COMPRESSION_NONE || text.compression == PNG_ITXT_COMPRESSION_zTXt;
    const std::string_view value(text.text, is_utf8 ? text.itxt_length : text.text_length);
    settings.insert_or_assign(Utf8OfLatin1(text.key), is_utf8 ? std::string(value) : Utf8OfLatin1(value));
  }
  return settings;
}

bool IsAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// --- reading ---

/// The layout of the library's rows: r g b, or r g b and alpha, with the high byte first.
struct RowLayout {
  bool is_16_bit = false, has_alpha = false;
};

/// Owns the library's reader of one image.
class Reader {
 public:
  explicit Reader(std::span<const unsigned char> bytes) : rest_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &jump_, OnError, OnWarning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, this, OnRead);
    png_set_user_limits(png_, max_pixels, max_pixels);
    png_set_chunk_malloc_max(png_, most_chunk_bytes);
    png_set_chunk_cache_max(png_, most_chunks);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Reads everything before the pixels. Requests r g b in 8 or 16 bits, whatever the file has, and alpha if it has
  /// some.
  void Start() {
    Do([&] {
      png_read_info(png_, info_);
      packed_row_bytes_ = png_get_rowbytes(png_, info_);
      png_set_expand(png_);  // palettes to colors, 1, 2 and 4 bits to 8, a transparent color to alpha
      png_set_gray_to_rgb(png_);
      passes_ = png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    height_ = png_get_image_height(png_, info_);
  }

  /// Returns the settings of all chunks before the pixels.
  ImageSettings Settings() {
    Do([&] { png_read_info(png_, info_); });
    return Texts();
  }

  /// Returns true if the file states colors other than sRGB, by a profile or by a gamma alone.
  bool HasOtherColors() {
    png_charp name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 length = 0;
    int ignored = 0;
    double gamma = 0;
    bool has_profile = false, has_srgb = false, has_gamma = false;
    Do([&] {
      has_srgb = png_get_sRGB(png_, info_, &ignored) != 0;
      has_profile = png_get_iCCP(png_, info_, &name, &ignored, &profile, &length) != 0;
      has_gamma = png_get_gAMA(png_, info_, &gamma) != 0;
    });
    if (has_srgb) return false;
    if (has_profile) return !IsNamedSrgb({profile, length});
    // Writers round 1/2.2 to anything from .45 to .4546.
    constexpr double usual_gamma = 1 / 2.2, rounding = 0.01;
    return has_gamma && std::abs(gamma - usual_gamma) > rounding;
  }

  bool IsInterlaced() const { return passes_ > 1; }
  RowLayout Layout() const { return {png_get_bit_depth(png_, info_) == 16, png_get_channels(png_, info_) == 4}; }
  std::size_t RowBytes() const { return png_get_rowbytes(png_, info_); }
  std::size_t PackedRowBytes() const { return packed_row_bytes_; }  // as stored in the file

  void ReadRow(std::span<unsigned char> row) {
    Do([&] { png_read_row(png_, row.data(), nullptr); });
    ++rows_read_;
  }

  /// Reads all rows of an image whose rows come in several passes.
  std::vector<unsigned char> ReadInterlaced() {
    std::vector<unsigned char> rows(RowBytes() * height_);
    for (int pass = 0; pass < passes_; ++pass) {
      rows_read_ = 0;
      is_last_pass_ = pass == passes_ - 1;
      for (std::size_t y = 0; y < height_; ++y) ReadRow(std::span(rows).subspan(y * RowBytes(), RowBytes()));
    }
    return rows;
  }

  /// Reads up to the end, so that text after the pixels counts. If the file merely lacks its end, the whole image has
  /// been read by then.
  ImageSettings Finish() {
    if (!Completes(jump_, [&] { png_read_end(png_, info_); }) && !is_truncated_) Refuse();
    return Texts();
  }

 private:
  ImageSettings Texts() {
    png_textp texts = nullptr;
    int count = 0;
    Do([&] { png_get_text(png_, info_, &texts, &count); });
    return FromText({texts, static_cast<std::size_t>(count)});
  }

  static void OnRead(png_structp png, png_bytep to, std::size_t count) {
    auto& reader = *static_cast<Reader*>(png_get_io_ptr(png));
    if (count > reader.rest_.size()) {
      reader.is_truncated_ = true;
      reader.jump_.Leave("truncated");
    }
    std::memcpy(to, reader.rest_.data(), count);
    reader.rest_ = reader.rest_.subspan(count);
  }

  template <typename Call>
  void Do(const Call& call) {
    if (!Completes(jump_, call)) Refuse();
  }

  /// Throws an ImageError with the library's message and the number of rows read.
  [[noreturn]] void Refuse() const {
    const std::size_t rows = is_last_pass_ || !IsInterlaced() ? rows_read_ : 0;
    const std::string there = std::to_string(rows) + " of " + std::to_string(height_) + " rows";
    if (!is_truncated_) throw ImageError("PNG is damaged" + (height_ ? ", after " + there : "") + ": " + jump_.message);
    if (height_ == 0) throw ImageError("PNG is truncated: it has no pixels");
    throw ImageError("PNG is truncated: " + there + " are present");
  }

  std::span<const unsigned char> rest_;
  Jump jump_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  std::size_t height_ = 0, rows_read_ = 0, packed_row_bytes_ = 0;
  bool is_last_pass_ = false, is_truncated_ = false;
};

/// Sets the colors of a row with `channels` channels of `bytes` bytes. Returns true if all its pixels are opaque.
template <std::size_t channels, std::size_t bytes>
bool SetRowOf(Image& image, int y, std::span<const unsigned char> row) {
  constexpr int largest = bytes == 2 ? 65535 : 255;
  bool is_opaque = true;
  const unsigned char* p = row.data();
  for (int x = 0; x < image.Width(); ++x, p += channels * bytes) {
    const auto channel = [&](std::size_t i) { return bytes == 2 ? p[2 * i] << 8 | p[2 * i + 1] : p[i]; };
    constexpr double scale = largest;
    image.Set(x, y, {channel(0) / scale, channel(1) / scale, channel(2) / scale});
    if constexpr (channels == 4) is_opaque &= channel(3) == largest;
  }
  return is_opaque;
}

bool SetRow(Image& image, int y, std::span<const unsigned char> row, const RowLayout& layout) {
  if (layout.has_alpha) return layout.is_16_bit ? SetRowOf<4, 2>(image, y, row) : SetRowOf<4, 1>(image, y, row);
  return layout.is_16_bit ? SetRowOf<3, 2>(image, y, row) : SetRowOf<3, 1>(image, y, row);
}

/// Reads all rows of the image. Returns true if all pixels are opaque.
bool ReadRows(Reader& reader, Image& image) {
  const RowLayout layout = reader.Layout();
  bool is_opaque = true;
  if (reader.IsInterlaced()) {
    const auto rows = reader.ReadInterlaced();
    std::span<const unsigned char> rest = rows;
    for (int y = image.Height() - 1; y >= 0; --y, rest = rest.subspan(reader.RowBytes()))
      is_opaque &= SetRow(image, y, rest.first(reader.RowBytes()), layout);
    return is_opaque;
  }
  std::vector<unsigned char> row(reader.RowBytes());
  for (int y = image.Height() - 1; y >= 0; --y) {
    reader.ReadRow(row);
    is_opaque &= SetRow(image, y, row, layout);
  }
  return is_opaque;
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  const ImageSize size = ReadStoredSize(bytes);
  CheckPngChunks(bytes);
  Reader reader(bytes);
  reader.Start();
  if (reader.PackedRowBytes() * static_cast<unsigned>(size.height) > most_deflate_ratio * bytes.size()) {
    throw ImageError("PNG is truncated: its " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " pixels cannot come out of " + std::to_string(bytes.size()) + " bytes");
  }

  DecodedImage decoded{Image(size.width, size.height)};
  const bool is_opaque = ReadRows(reader, decoded.image);
  const PngEnd end = FindPngEnd(bytes);
  decoded.settings = reader.Finish();
  Turn(decoded, PngOrientation(bytes));
  if (!is_opaque)
    decoded.warnings.push_back("PNG has transparent pixels: alpha is ignored, their colors count in full");
  if (reader.HasOtherColors())
    decoded.warnings.push_back("PNG has a color profile or a gamma other than sRGB's, which is not applied");
  if (!end.has_end_chunk) decoded.warnings.push_back("PNG has no end chunk (IEND), but all its rows are present");
  WarnOfBytesBehind(decoded, "PNG", end.bytes_behind);
  return decoded;
}

ImageSettings ReadSettings(std::span<const unsigned char> bytes) {
  CheckPngChunks(bytes);
  const std::vector<unsigned char> rest = PngWithoutPixels(bytes);
  return Reader(rest).Settings();
}

// --- writing ---

/// Returns the 16-bit channels of a row, big-endian as in the file.
std::vector<unsigned char> ShortRow(const Image& image, int y, const ImageEncoding& encoding) {
  std::vector<unsigned char> row;
  row.reserve(6 * static_cast<std::size_t>(image.Width()));
  for (int x = 0; x < image.Width(); ++x) {
    const Color c = image.At(x, y);
    for (double channel : {c.r, c.g, c.b}) {
      const unsigned short value = ToShort(EncodedChannel(channel, encoding), encoding.quantization);
      row.push_back(static_cast<unsigned char>(value >> 8));
      row.push_back(static_cast<unsigned char>(value & 255));
    }
  }
  return row;
}

/// Owns the library's writer of one image.
class Writer {
 public:
  Writer() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &jump_, OnError, OnWarning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, this, OnWrite, nullptr);
    png_set_user_limits(png_, max_pixels, max_pixels);
    png_set_compression_level(png_, compression_level);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void Start(ImageSize size, const ImageEncoding& encoding, const ImageSettings& settings) {
    std::vector<png_text> texts;
    for (const auto& [key, value] : settings) {
      png_text text{};
      text.compression = IsAscii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
      // The parameter is not const, but the library only copies the text.
      text.key = const_cast<char*>(key.c_str());
      text.text = const_cast<char*>(value.c_str());
      texts.push_back(text);
    }
    Do([&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height),
                   encoding.bits == 16 ? 16 : 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      // Linear values get no gAMA 1.0 chunk: programs that honor it would show the image brighter than the same one as
      // JPEG or PPM, where linear values are meant to be shown unchanged.
      if (encoding.srgb) png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
      if (!texts.empty()) png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
      png_write_info(png_, info_);
    });
  }

  void WriteRow(std::span<const unsigned char> row) {
    Do([&] { png_write_row(png_, row.data()); });
  }

  std::vector<unsigned char> Finish() {
    Do([&] { png_write_end(png_, nullptr); });
    return std::move(bytes_);
  }

 private:
  static void OnWrite(png_structp png, png_bytep from, std::size_t count) {
    auto& writer = *static_cast<Writer*>(png_get_io_ptr(png));
    if (!Append(writer.bytes_, from, count)) writer.jump_.Leave("not enough memory");
  }

  template <typename Call>
  void Do(const Call& call) {
    if (!Completes(jump_, call)) throw ImageError(std::string("PNG cannot be written: ") + jump_.message);
  }

  Jump jump_;
  std::vector<unsigned char> bytes_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding& encoding, const ImageSettings& settings) {
  Writer writer;
  writer.Start({image.Width(), image.Height()}, encoding, WritableAsPng(settings));
  for (int y = image.Height() - 1; y >= 0; --y) {
    writer.WriteRow(encoding.bits == 16 ? ShortRow(image, y, encoding) : ByteRow(image, y, encoding));
  }
  return writer.Finish();
}

}  // namespace
}  // namespace png

extern const ImageFormat png_format{"png",       {"png"}, png::Recognizes, png::ReadSize,    png::Decode,
                                    png::Encode, false,   nullptr,         png::ReadSettings};

}  // namespace R2
