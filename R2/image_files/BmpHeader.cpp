#include "R2/image_files/BmpHeader.h"

#include <algorithm>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

namespace R2::bmp {
namespace {

constexpr std::uint32_t core_header_size = 12, least_os2_size = 16, info_header_size = 40, os2_header_size = 64;

/// The fields of the info header; missing fields are zero.
struct InfoHeader {
  std::uint32_t size = 0;
  std::int64_t width = 0, height = 0;
  int bits = 0;
  std::uint32_t compression = 0, image_bytes = 0, colors = 0;
  std::array<std::uint32_t, 4> masks{};  // red, green, blue, alpha
  std::uint32_t profile_bytes = 0;

  bool IsCore() const { return size == core_header_size; }
  bool IsOs2() const { return !IsCore() && (size < info_header_size || size == os2_header_size); }
  /// Returns true if the header contains the masks, as later versions do; otherwise they follow the header.
  bool HoldsMasks() const { return size > info_header_size && size != os2_header_size; }
  /// Returns the number of masks that follow the header.
  int MasksBehind() const {
    if (HoldsMasks() || IsCore() || IsOs2()) return 0;
    return compression == 3 ? 3 : compression == 6 ? 4 : 0;
  }
};

/// Reads a field of a header that may end early; missing fields are 0.
std::uint32_t FieldOr0(ByteReader& header) { return header.Left() < 4 ? 0 : header.Little32("the info header"); }

InfoHeader ReadInfoHeader(ByteReader& reader) {
  InfoHeader info;
  info.size = reader.Little32("the info header");
  if (info.size != core_header_size && info.size < least_os2_size) reader.Fail("has a header of an unknown kind");
  ByteReader header("BMP", reader.Take(info.size - 4, "the info header"));
  const bool is_core = info.IsCore();
  info.width = is_core ? header.Little16("the width") : header.LittleSigned32("the width");
  info.height = is_core ? header.Little16("the height") : header.LittleSigned32("the height");
  header.Little16("the planes");
  info.bits = header.Little16("the bits per pixel");
  info.compression = FieldOr0(header);
  info.image_bytes = FieldOr0(header);
  FieldOr0(header), FieldOr0(header);  // pixels per meter
  info.colors = FieldOr0(header);
  FieldOr0(header);  // number of important colors
  if (info.HoldsMasks()) {
    for (std::uint32_t& mask : info.masks) mask = FieldOr0(header);
    // The last version ends with the color calibration, and the position and size of a profile.
    constexpr std::uint64_t before_profile_size = 60;
    if (header.Left() >= before_profile_size + 4) {
      header.Take(before_profile_size, "the info header");
      info.profile_bytes = header.Little32("the info header");
    }
  }
  for (int i = 0; i < info.MasksBehind(); ++i)
    info.masks[static_cast<std::size_t>(i)] = reader.Little32("the bit fields");
  return info;
}

/// Throws if the compression is not supported.
void CheckCompression(const ByteReader& reader, const InfoHeader& info) {
  const std::uint32_t compression = info.compression;
  if (compression == 4 && !info.IsOs2()) reader.Fail("contains a JPEG instead of pixels, which is not supported");
  if (compression == 5) reader.Fail("contains a PNG instead of pixels, which is not supported");
  constexpr std::array depths{1, 2, 4, 8, 16, 24, 32};
  if (std::ranges::find(depths, info.bits) == depths.end())
    reader.Fail("has " + std::to_string(info.bits) + " bits per pixel; 1, 2, 4, 8, 16, 24 and 32 are read");
  const bool has_bit_fields = (compression == 3 || compression == 6) && !info.IsOs2();
  const bool is_read = compression == 0 || (compression == 1 && info.bits == 8) ||
                       (compression == 2 && info.bits == 4) || (has_bit_fields && (info.bits == 16 || info.bits == 32));
  if (!is_read)
    reader.Fail("has compression " + std::to_string(compression) + " with " + std::to_string(info.bits) +
                " bits per pixel; run lengths of 8 and 4 bits and bit fields of 16 and 32 bits are read");
}

/// Returns true if the ones of a mask are contiguous.
bool IsContiguous(std::uint32_t mask) {
  return mask == 0 || ((mask / (mask & -mask)) & (mask / (mask & -mask) + 1)) == 0;
}

/// Reads the masks. They count only if the compression says so: later headers have room for them in any case.
BitFields FieldsOf(const ByteReader& reader, const InfoHeader& info) {
  if (info.compression != 3 && info.compression != 6)
    return info.bits == 16 ? BitFields{{0x7c00}, {0x3e0}, {0x1f}, {}} : BitFields{};
  const auto& [red, green, blue, alpha] = info.masks;
  std::uint32_t seen = 0;
  for (const std::uint32_t mask : info.masks) {
    if (!IsContiguous(mask) || (mask & seen) != 0) reader.Fail("has bit fields with gaps, or that overlap");
    seen |= mask;
  }
  if ((red | green | blue) == 0) reader.Fail("has bit fields without a bit");
  return {{red}, {green}, {blue}, {alpha}};
}

/// Locates palette and pixels. The file header states where pixels start, but some writers state a position within the
/// header or the palette, as if there were no palette, or none at all; others write a palette shorter than the header
/// states.
void FindPixels(Header& header, const InfoHeader& info, std::uint64_t palette_start, std::uint64_t stated,
                std::span<const unsigned char> file) {
  const std::uint64_t most_colors = std::uint64_t{1} << std::min(header.bits, 8);
  const std::uint64_t stated_colors =
      info.colors == 0 ? most_colors : std::min<std::uint64_t>(info.colors, most_colors);
  std::uint64_t colors = header.HasPalette() ? stated_colors : 0;
  const std::uint64_t palette_end = palette_start + header.palette_entry * colors;
  const std::uint64_t pixel_bytes =
      header.is_run_length ? info.image_bytes
                           : header.RowStride() * static_cast<unsigned>(header.size.height - 1) + header.RowBytes();
  header.pixels_start = stated;
  if (stated < palette_end) {
    const bool may_follow_palette = palette_end <= file.size() && pixel_bytes <= file.size() - palette_end;
    if (stated > palette_start && !may_follow_palette) {
      colors = (stated - palette_start) / header.palette_entry;
    } else {
      header.pixels_start = palette_end;
      header.warnings.push_back("BMP states that its pixels start at byte " + std::to_string(stated) + ", within its " +
                                (stated < palette_start ? "header" : "palette") + "; they are read from byte " +
                                std::to_string(palette_end) + " on");
    }
  }
  if (!header.HasPalette()) return;
  ByteReader reader("BMP", file);
  reader.Take(palette_start, "the header");
  header.palette = reader.Take(header.palette_entry * colors, "the palette");
}

}  // namespace

Header ReadHeader(std::span<const unsigned char> file) {
  ByteReader reader("BMP", file);
  reader.Take(10, "the file header");
  const std::uint64_t pixels_start = reader.Little32("the file header");
  const InfoHeader info = ReadInfoHeader(reader);
  Header header;
  header.size = CheckedSize("BMP", info.width, info.height < 0 ? -info.height : info.height);
  header.is_top_down = info.height < 0;
  CheckCompression(reader, info);
  header.bits = info.bits;
  header.is_run_length = info.compression == 1 || info.compression == 2;
  header.fields = FieldsOf(reader, info);
  header.palette_entry = info.IsCore() ? 3 : 4;
  header.profile_bytes = info.profile_bytes;
  FindPixels(header, info, file.size() - reader.Left(), pixels_start, file);
  return header;
}

}  // namespace R2::bmp
