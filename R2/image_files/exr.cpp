#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "R2/image_files/ByteReader.h"
#include "R2/image_files/formats.h"

// OpenEXR through its library: channels R G B, or Y for gray, of a single flat part, of any pixel type, in scan lines
// or tiles. What is read is the data window; the display window around it, and alpha, are left out. Written as
// float scan lines, ZIP compressed. Settings live in string attributes.
// source: Kainz, Bogart, Stanczyk, Hillman, Technical Introduction to OpenEXR (2013); OpenEXR File Layout (2013)
namespace R2 {

namespace {

// Set before our own keys, since a bare "channels" or "type" would be taken for the format's own attribute.
constexpr std::string_view settings_prefix = "raypro:";
constexpr std::size_t longest_name = 255;  // what the format allows

/// What the checks before the library need to know. The library itself believes every size in the header.
struct Header {
  ImageSize size;
  bool is_tiled = false;
  std::uint64_t tile_width = 0, tile_height = 0;
  int compression = 0;
};

bool Recognises(std::span<const unsigned char> bytes) {
  constexpr std::array<unsigned char, 4> magic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

ImageSize ReadDataWindow(ByteReader window) {
  const std::int64_t x_min = window.LittleSigned32("the data window"), y_min = window.LittleSigned32("the data window");
  const std::int64_t x_max = window.LittleSigned32("the data window"), y_max = window.LittleSigned32("the data window");
  return CheckedSize("EXR", x_max - x_min + 1, y_max - y_min + 1);
}

/// Steps over the attributes (name, type, size, value) and checks that each lies within the file.
Header ReadHeader(ByteReader& reader) {
  constexpr std::uint32_t tiled_flag = 0x200, deep_flag = 0x800, multipart_flag = 0x1000;
  reader.Take(4, "the magic number");
  const std::uint32_t version = reader.Little32("the version");
  if ((version & 0xff) != 2) reader.Fail("has a version other than 2");
  if (version & (deep_flag | multipart_flag))
    reader.Fail("has several parts or deep pixels; a single flat part is read");

  Header header;
  header.is_tiled = version & tiled_flag;
  for (std::string_view name; !(name = reader.Until('\0', "the header")).empty();) {
    reader.Until('\0', "the header");
    const auto value = reader.Take(reader.Little32("the header"), "an attribute");
    ByteReader value_reader("EXR", value);
    if (name == "dataWindow") header.size = ReadDataWindow(value_reader);
    if (name == "compression") header.compression = value_reader.Byte("the compression");
    if (name == "tiles") {
      header.tile_width = value_reader.Little32("the tile size");
      header.tile_height = value_reader.Little32("the tile size");
    }
  }
  if (header.size.width == 0) reader.Fail("has no data window");
  return header;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  ByteReader reader("EXR", bytes);
  return ReadHeader(reader).size;
}

/// How many rows are compressed together, by the number of the compression; a number that is none is left to the
/// library to refuse.
std::uint64_t RowsTogether(int compression) {
  constexpr std::array<std::uint64_t, 10> rows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  return compression < static_cast<int>(rows.size()) ? rows[static_cast<std::size_t>(compression)] : 256;
}

std::uint64_t Quotient(std::uint64_t whole, std::uint64_t part) { return (whole + part - 1) / part; }

/// Behind the header comes a table, 8 bytes for every block of rows or tile, and then the blocks, which have 8 bytes
/// at least themselves: the library makes room for it all at once, so it had better be there.
void CheckBlocks(const ByteReader& reader, const Header& header) {
  const auto width = static_cast<std::uint64_t>(header.size.width);
  const auto height = static_cast<std::uint64_t>(header.size.height);
  std::uint64_t blocks = Quotient(height, RowsTogether(header.compression));
  if (header.is_tiled) {
    constexpr std::uint64_t usual_tile = 1024 * 1024;
    const std::uint64_t most = std::max(width * height, usual_tile);
    if (header.tile_width < 1 || header.tile_height < 1 || header.tile_width > most / header.tile_height) {
      reader.Fail("has no tiles, or tiles much larger than the picture");
    }
    // The library keeps one row of tiles unpacked.
    if (header.tile_height > static_cast<std::uint64_t>(max_pixels) / width) {
      reader.Fail("has too many pixels in a row of tiles");
    }
    blocks = Quotient(width, header.tile_width) * Quotient(height, header.tile_height);
  }
  reader.Need(blocks * 16, "the picture");
}

/// The bytes of a file, for the library.
class InputStream : public Imf::IStream {
 public:
  explicit InputStream(std::span<const unsigned char> bytes) : IStream("the image"), bytes_(bytes) {}

  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::uint64_t>(std::max(count, 0));
    if (position_ > bytes_.size() || wanted > bytes_.size() - position_) throw ImageError("EXR is truncated");
    std::memcpy(to, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const unsigned char> bytes_;
  std::uint64_t position_ = 0;
};

class OutputStream : public Imf::OStream {
 public:
  OutputStream() : OStream("the image") {}

  void write(const char from[], int count) override {
    const auto length = static_cast<std::size_t>(count);
    if (position_ + length > bytes_.size()) bytes_.resize(position_ + length);
    std::memcpy(bytes_.data() + position_, from, length);
    position_ += length;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<unsigned char> Take() { return std::move(bytes_); }

 private:
  std::vector<unsigned char> bytes_;
  std::uint64_t position_ = 0;
};

constexpr std::array color_channels{"R", "G", "B"};
constexpr std::array gray_channel{"Y"};

/// Describes one row of r g b floats, whose first pixel is at x = `x_min`, as the library's frame for any y. One
/// channel alone takes the place of r.
Imf::FrameBuffer RowFrame(std::vector<float>& row, int x_min, std::span<const char* const> channels) {
  constexpr std::size_t pixel_bytes = 3 * sizeof(float);
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    // The library adds x * pixel_bytes again. As integers, because x_min pixels before the row there is no memory.
    const auto address = reinterpret_cast<std::intptr_t>(row.data() + i) -
                         static_cast<std::intptr_t>(x_min) * static_cast<std::intptr_t>(pixel_bytes);
    frame.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(address), pixel_bytes, 0));
  }
  return frame;
}

/// Attribute names in the library's messages come from the file, and may be anything.
std::string Printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

ImageSettings SettingsOf(const Imf::Header& header) {
  ImageSettings settings;
  for (auto i = header.begin(); i != header.end(); ++i) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
    if (!text) continue;
    std::string name = i.name();
    if (name.starts_with(settings_prefix)) name.erase(0, settings_prefix.size());
    settings.insert_or_assign(name, text->value());
  }
  return settings;
}

Image ReadPixels(Imf::InputFile& file, ImageSize size) {
  const auto& channels = file.header().channels();
  const bool has_color = channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B");
  if (!has_color && !channels.findChannel("Y")) throw ImageError("EXR has neither the channels R, G and B nor Y");

  const Imath::Box2i window = file.header().dataWindow();
  std::vector<float> row(3 * static_cast<std::size_t>(size.width));
  file.setFrameBuffer(has_color ? RowFrame(row, window.min.x, color_channels)
                                : RowFrame(row, window.min.x, gray_channel));
  // The picture is asked for only once its first row is there: the header alone may promise anything.
  Image image;
  for (int y = size.height - 1; y >= 0; --y) {
    const int line = window.min.y + (size.height - 1 - y);
    try {
      file.readPixels(line, line);
    } catch (const std::exception& error) {
      throw ImageError("EXR is truncated or damaged: " + std::to_string(size.height - 1 - y) + " of " +
                       std::to_string(size.height) + " rows are there: " + Printable(error.what()));
    }
    if (image.Width() == 0) image = Image(size.width, size.height);
    for (int x = 0; x < size.width; ++x) {
      const float* p = &row[3 * static_cast<std::size_t>(x)];
      image.Set(x, y, {p[0], p[has_color ? 1 : 0], p[has_color ? 2 : 0]});
    }
  }
  return image;
}

Image Decode(std::span<const unsigned char> bytes, ImageSettings* settings) {
  ByteReader reader("EXR", bytes);
  const Header header = ReadHeader(reader);
  CheckBlocks(reader, header);
  try {
    InputStream stream(bytes);
    Imf::InputFile file(stream, 0);  // no threads of the library's own
    if (settings) *settings = SettingsOf(file.header());
    return ReadPixels(file, header.size);
  } catch (const ImageError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR is damaged: " + Printable(error.what()));
  }
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding&, const ImageSettings& settings) {
  Imf::Header header(image.Width(), image.Height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : color_channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : settings) {
    const std::string name = std::string(settings_prefix) + key;
    header.insert(name.substr(0, longest_name), Imf::StringAttribute(value));
  }
  OutputStream stream;
  try {
    Imf::OutputFile file(stream, header, 0);
    std::vector<float> row(3 * static_cast<std::size_t>(image.Width()));
    file.setFrameBuffer(RowFrame(row, 0, color_channels));
    for (int y = image.Height() - 1; y >= 0; --y) {
      const auto first =
          image.Channels().begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row.size());
      std::copy_n(first, row.size(), row.begin());
      file.writePixels(1);
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR cannot be written: " + Printable(error.what()));
  }
  return stream.Take();
}

}  // namespace

const ImageFormat exr_format{"exr", {"exr"}, Recognises, ReadSize, Decode, Encode, true};

}  // namespace R2
