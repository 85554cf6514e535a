#include "R2/image_files/ExrLayout.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <utility>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

namespace R2 {
namespace {

// The file's numbers of the compressions that are checked here.
constexpr int none = 0, run_length = 1, zip_of_one_row = 2, zip = 3;

ExrWindow ReadWindow(ByteReader& value) {
  const std::int64_t x_min = value.LittleSigned32("a window"), y_min = value.LittleSigned32("a window");
  const std::int64_t x_max = value.LittleSigned32("a window"), y_max = value.LittleSigned32("a window");
  return {x_min, y_min, CheckedSize("EXR", x_max - x_min + 1, y_max - y_min + 1)};
}

std::int64_t Area(const ImageSize& size) { return std::int64_t{size.width} * size.height; }

/// Limits the margin around the data window. It takes no bytes in the file, so a few bytes could request any size:
/// images up to 8192 x 8192 pixels are accepted from any file, larger ones if at least a sixteenth of the pixels is
/// stored.
void CheckMargin(const ByteReader& reader, const ExrLayout& layout) {
  constexpr std::int64_t made_of_any_file = 8192 * 8192, most_made_of_one = 16;
  const std::int64_t area = Area(layout.display.size);
  if (area <= made_of_any_file || area / most_made_of_one <= Area(layout.data.size)) return;
  reader.Fail("has " + std::to_string(layout.data.size.width) + " x " + std::to_string(layout.data.size.height) +
              " pixels for an image of " + std::to_string(layout.display.size.width) + " x " +
              std::to_string(layout.display.size.height));
}

ImageChannel::Type TypeOf(std::uint32_t type) {
  constexpr std::array types{ImageChannel::Type::uint32, ImageChannel::Type::half16};
  return type < types.size() ? types[type] : ImageChannel::Type::float32;
}

std::vector<ExrChannel> ReadChannels(ByteReader& value) {
  constexpr int half = 1;
  std::vector<ExrChannel> channels;
  for (std::string_view name; !(name = value.Until('\0', "the channels")).empty();) {
    ExrChannel channel;
    channel.name = name;
    const std::uint32_t type = value.Little32("a channel");
    channel.type = TypeOf(type);
    channel.bytes = type == half ? 2 : 4;
    value.Take(4, "a channel");
    channel.x_sampling = value.LittleSigned32("a channel");
    channel.y_sampling = value.LittleSigned32("a channel");
    if (channel.x_sampling < 1 || channel.y_sampling < 1) value.Fail("has a channel without samples");
    channels.push_back(channel);
  }
  return channels;
}

/// Returns true if the size of an attribute is that of its type. For most types the library reads a fixed number of
/// bytes regardless of the stated size, and would misinterpret what follows, including sizes that it allocates.
///   source   OpenEXR File Layout (2013), "Attribute Types"
bool HasSizeOfType(std::string_view type, ByteReader value) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 23> sizes{
      {{"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
       {"compression", 1}, {"double", 8},   {"envmap", 1},
       {"float", 4},       {"int", 4},      {"keycode", 28},
       {"lineOrder", 1},   {"m33d", 72},    {"m33f", 36},
       {"m44d", 128},      {"m44f", 64},    {"rational", 8},
       {"tiledesc", 9},    {"timecode", 8}, {"v2d", 16},
       {"v2f", 8},         {"v2i", 8},      {"v3d", 24},
       {"v3f", 12},        {"v3i", 12}}};
  const auto fixed = std::ranges::find(sizes, type, &std::pair<std::string_view, std::uint64_t>::first);
  if (fixed != sizes.end()) return value.Left() == fixed->second;
  if (type == "deepImageState") return value.Left() == 1;
  if (type == "chlist") ReadChannels(value);
  if (type == "preview") {
    // Clamped to keep the product from overflowing.
    const auto side = [&] { return std::min<std::uint64_t>(value.Little32("a size"), max_pixels); };
    value.Take(4 * side() * side(), "a preview");
  }
  while (type == "stringvector" && value.Left() > 0) value.Take(value.Little32("a length"), "a text");
  const bool is_read_to_its_end = type == "chlist" || type == "preview" || type == "stringvector";
  return !is_read_to_its_end || value.Left() == 0;
}

/// Returns the number of rows that are compressed together. Unknown compressions are left for the library to reject.
int RowsTogether(int compression) {
  constexpr std::array rows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  return compression < static_cast<int>(rows.size()) ? rows[static_cast<std::size_t>(compression)] : 256;
}

void CheckTiles(const ByteReader& reader, const ExrLayout& layout) {
  const auto width = static_cast<std::uint64_t>(layout.data.size.width);
  const auto height = static_cast<std::uint64_t>(layout.data.size.height);
  constexpr std::uint64_t usual_tile = 1024 * 1024;
  const std::uint64_t most = std::max(width * height, usual_tile);
  if (layout.tile_width < 1 || layout.tile_height < 1 || layout.tile_width > most / layout.tile_height) {
    reader.Fail("has no tiles, or tiles much larger than the image");
  }
  // The library keeps one row of tiles uncompressed.
  if (layout.tile_height > static_cast<std::uint64_t>(max_pixels) / width) {
    reader.Fail("has too many pixels in a row of tiles");
  }
}

std::int64_t Quotient(std::int64_t whole, std::int64_t part) { return (whole + part - 1) / part; }

/// Returns the bytes of all samples in `width` columns of the rows [first, last) of the data window. The library
/// ensures that sampling steps divide the window.
std::uint64_t PixelBytes(const ExrLayout& layout, int width, int first, int last) {
  std::int64_t bytes = 0;
  for (const ExrChannel& channel : layout.channels) {
    const std::int64_t rows = Quotient(last, channel.y_sampling) - Quotient(first, channel.y_sampling);
    bytes += rows * (width / channel.x_sampling) * channel.bytes;
  }
  return static_cast<std::uint64_t>(bytes);
}

/// Returns the uncompressed size of run-length encoded bytes: a negative count is followed by that many plain bytes,
/// any other by one byte to repeat.
std::uint64_t RunLengthUnpacked(std::span<const unsigned char> packed) {
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < packed.size();) {
    const int count = static_cast<signed char>(packed[i]);  // NOLINT(bugprone-signed-char-misuse): runs below 0
    length += static_cast<std::uint64_t>(count < 0 ? -count : count + 1);
    i += static_cast<std::size_t>(count < 0 ? 1 - count : 2);
  }
  return length;
}

/// Returns the uncompressed size of a zlib stream; any value above `most` if it is larger than that, 0 if it is
/// damaged.
std::uint64_t Inflated(std::span<const unsigned char> packed, std::uint64_t most) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<unsigned char*>(packed.data());  // only read
  stream.avail_in = static_cast<unsigned>(packed.size());
  std::array<unsigned char, 16384> unpacked;
  int state = Z_OK;
  while (state == Z_OK && stream.total_out <= most) {
    stream.next_out = unpacked.data();
    stream.avail_out = static_cast<unsigned>(unpacked.size());
    state = inflate(&stream, Z_NO_FLUSH);
  }
  const std::uint64_t length = state == Z_STREAM_END || state == Z_OK ? stream.total_out : 0;
  inflateEnd(&stream);
  return length;
}

/// Returns true if a block contains `expected` bytes of pixels.
bool Holds(std::span<const unsigned char> block, std::uint64_t expected, int compression) {
  if (block.size() >= expected) return block.size() == expected;  // incompressible data is stored as it is
  if (compression == none) return false;
  if (compression == run_length) return RunLengthUnpacked(block) == expected;
  if (compression == zip || compression == zip_of_one_row) return Inflated(block, expected) == expected;
  return true;  // the library checks the others
}

/// Returns the compressed bytes of the block at `place`, which starts with its coordinates.
std::span<const unsigned char> Block(std::span<const unsigned char> bytes, std::uint64_t place, int coordinates) {
  ByteReader reader("EXR", bytes);
  reader.Take(place, "what comes before a block");
  reader.Take(std::uint64_t{4} * static_cast<unsigned>(coordinates), "a block");
  return reader.Take(reader.Little32("a block"), "a block");
}

/// Returns the end of the block at `place`; std::nullopt unless it is inside the file and contains the expected number
/// of pixel bytes.
std::optional<std::uint64_t> EndOfBlock(std::span<const unsigned char> bytes, const ExrLayout& layout,
                                        std::uint64_t place, std::uint64_t expected) {
  try {
    const auto block = Block(bytes, place, layout.is_tiled ? 4 : 1);
    if (!Holds(block, expected, layout.compression)) return {};
    return static_cast<std::uint64_t>(block.data() + block.size() - bytes.data());
  } catch (const ImageError&) {
    return {};  // beyond the end
  }
}

}  // namespace

/// Reads the attributes in turn: name, type, size, value.
ExrLayout ReadExrLayout(std::span<const unsigned char> bytes) {
  constexpr std::uint32_t tiled_flag = 0x200, deep_flag = 0x800, multipart_flag = 0x1000;
  ByteReader reader("EXR", bytes);
  reader.Take(4, "the magic number");
  const std::uint32_t version = reader.Little32("the version");
  if ((version & 0xff) != 2) reader.Fail("has a version other than 2");
  if (version & deep_flag) reader.Fail("has deep pixels (several samples each), which are not supported");
  if (version & multipart_flag) reader.Fail("has several parts, which are not supported");

  ExrLayout layout;
  layout.is_tiled = version & tiled_flag;
  for (std::string_view name; !(name = reader.Until('\0', "the header")).empty();) {
    const std::string_view type = reader.Until('\0', "the header");
    ByteReader value("EXR", reader.Take(reader.Little32("the header"), "an attribute"));
    if (!HasSizeOfType(type, value)) reader.Fail("has an attribute whose size is not that of its type");
    if (name == "dataWindow") layout.data = ReadWindow(value);
    if (name == "displayWindow") layout.display = ReadWindow(value);
    if (name == "channels") layout.channels = ReadChannels(value);
    if (name == "compression") layout.compression = value.Byte("the compression");
    if (name == "tiles") {
      layout.tile_width = value.Little32("the tile size");
      layout.tile_height = value.Little32("the tile size");
      layout.has_smaller_copies =
          (value.Byte("the tile levels") & 15) != 0;  // the higher bits are the rounding mode of sizes
    }
  }
  if (layout.data.size.width == 0) reader.Fail("has no data window");
  if (layout.display.size.width == 0) reader.Fail("has no display window");
  CheckMargin(reader, layout);
  if (layout.channels.empty()) reader.Fail("has no channels");
  if (layout.is_tiled) CheckTiles(reader, layout);
  layout.table = bytes.size() - reader.Left();
  return layout;
}

std::uint64_t CheckExrBlocks(std::span<const unsigned char> bytes, const ExrLayout& layout) {
  ByteReader table("EXR", bytes);
  table.Take(layout.table, "the header");
  const auto [width, height] = layout.data.size;
  // A tile may be wider than any image.
  const int tile_width = static_cast<int>(std::min<std::uint64_t>(layout.tile_width, max_pixels));
  const int columns_together = layout.is_tiled ? tile_width : width;
  const int rows_together = layout.is_tiled ? static_cast<int>(layout.tile_height) : RowsTogether(layout.compression);
  const std::int64_t blocks = Quotient(width, columns_together) * Quotient(height, rows_together);
  table.Need(8 * static_cast<std::uint64_t>(blocks), "the table of blocks");

  std::uint64_t last_end = layout.table;
  // In a file with smaller copies of the image, the image itself comes first.
  for (int y = 0; y < height; y += rows_together) {
    for (int x = 0; x < width; x += columns_together) {
      const std::uint64_t low = table.Little32("the table of blocks"), high = table.Little32("the table of blocks");
      const int block_width = std::min(columns_together, width - x);
      const std::uint64_t expected = PixelBytes(layout, block_width, y, std::min(y + rows_together, height));
      const auto end = EndOfBlock(bytes, layout, low | high << 32, expected);
      if (!end)
        table.Fail("is truncated or damaged: " + std::to_string(y) + " of " + std::to_string(height) +
                   " rows are present");
      last_end = std::max(last_end, *end);
    }
  }
  return last_end;
}

}  // namespace R2
