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

#include "R2/image_files/ExrLayout.h"
#include "R2/image_files/formats.h"

// OpenEXR through its library: channels R G B, or Y for gray, of a single flat part, of any pixel type, in scan lines
// or tiles. The image is the display window: black where the data window holds none of it; what is stored beyond it,
// and alpha, are left out. Written as float scan lines, ZIP compressed. Settings live in string attributes.
// source: Kainz, Bogart, Stanczyk, Hillman, Technical Introduction to OpenEXR (2013); OpenEXR File Layout (2013)
namespace R2 {

namespace exr {
namespace {

// Set before our own keys, since a bare "channels" or "type" would be taken for the format's own attribute.
constexpr std::string_view settings_prefix = "raypro:";
constexpr std::size_t longest_name = 255;  // what the format allows

bool Recognizes(std::span<const unsigned char> bytes) {
  constexpr std::array<unsigned char, 4> magic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

ImageSize ReadSize(std::span<const unsigned char> bytes) { return ReadExrLayout(bytes).display.size; }

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

/// Adds one row of r g b floats, whose first pixel is at x = `x_min`, to the library's frame for any y. One channel
/// alone takes the place of r.
template <typename Names>
void AddToFrame(Imf::FrameBuffer& frame, std::vector<float>& row, int x_min, const Names& channels) {
  constexpr std::size_t pixel_bytes = 3 * sizeof(float);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    // The library adds x * pixel_bytes again. As integers, because x_min pixels before the row there is no memory.
    const auto address = reinterpret_cast<std::intptr_t>(row.data() + i) -
                         static_cast<std::intptr_t>(x_min) * static_cast<std::intptr_t>(pixel_bytes);
    frame.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(address), pixel_bytes, 0));
  }
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

/// The rows and columns that both windows have.
ExrWindow InBoth(const ExrWindow& a, const ExrWindow& b) {
  ExrWindow both{std::max(a.left, b.left), std::max(a.top, b.top), {}};
  both.size.width = static_cast<int>(std::max<std::int64_t>(0, std::min(a.Right(), b.Right()) - both.left));
  both.size.height = static_cast<int>(std::max<std::int64_t>(0, std::min(a.Bottom(), b.Bottom()) - both.top));
  return both;
}

Image ReadPixels(Imf::InputFile& file, const ExrLayout& layout) {
  const auto& channels = file.header().channels();
  const bool has_color = channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B");
  if (!has_color && !channels.findChannel("Y")) throw ImageError("EXR has neither the channels R, G and B nor Y");

  const ExrWindow &data = layout.data, &display = layout.display, read = InBoth(data, display);
  std::vector<float> row(3 * static_cast<std::size_t>(data.size.width));
  Imf::FrameBuffer frame;
  if (has_color)
    AddToFrame(frame, row, static_cast<int>(data.left), color_channels);
  else
    AddToFrame(frame, row, static_cast<int>(data.left), gray_channel);
  file.setFrameBuffer(frame);
  // The picture is asked for only once its first row is there: the header alone may promise anything.
  Image image;
  for (std::int64_t line = read.top; line < read.Bottom(); ++line) {
    try {
      file.readPixels(static_cast<int>(line), static_cast<int>(line));
    } catch (const std::exception& error) {
      throw ImageError("EXR is truncated or damaged: " + std::to_string(line - data.top) + " of " +
                       std::to_string(data.size.height) + " rows are there: " + Printable(error.what()));
    }
    if (image.Width() == 0) image = Image(display.size.width, display.size.height);
    const int y = static_cast<int>(display.Bottom() - 1 - line);
    for (std::int64_t x = read.left; x < read.Right(); ++x) {
      const float* p = &row[3 * static_cast<std::size_t>(x - data.left)];
      image.Set(static_cast<int>(x - display.left), y, {p[0], p[has_color ? 1 : 0], p[has_color ? 2 : 0]});
    }
  }
  return image.Width() > 0 ? std::move(image) : Image(display.size.width, display.size.height);
}

Image Decode(std::span<const unsigned char> bytes, ImageSettings* settings) {
  const ExrLayout layout = ReadExrLayout(bytes);
  CheckExrBlocks(bytes, layout);
  try {
    InputStream stream(bytes);
    Imf::InputFile file(stream, 0);  // no threads of the library's own
    if (settings) *settings = SettingsOf(file.header());
    return ReadPixels(file, layout);
  } catch (const ImageError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR is damaged: " + Printable(error.what()));
  }
}

ImageSettings ReadSettings(std::span<const unsigned char> bytes) {
  ReadExrLayout(bytes);
  try {
    InputStream stream(bytes);
    return SettingsOf(Imf::InputFile(stream, 0).header());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR is damaged: " + Printable(error.what()));
  }
}

std::vector<unsigned char> EncodeLayers(const Image& image, std::span<const ImageLayer> layers,
                                        const ImageSettings& settings) {
  Imf::Header header(image.Width(), image.Height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : color_channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  for (const ImageLayer& layer : layers)
    for (const std::string& channel : layer.channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : settings) {
    const std::string name = std::string(settings_prefix) + key;
    header.insert(name.substr(0, longest_name), Imf::StringAttribute(value));
  }
  OutputStream stream;
  try {
    Imf::OutputFile file(stream, header, 0);
    const std::size_t row_floats = 3 * static_cast<std::size_t>(image.Width());
    std::vector<std::vector<float>> rows(1 + layers.size(), std::vector<float>(row_floats));
    Imf::FrameBuffer frame;
    AddToFrame(frame, rows[0], 0, color_channels);
    for (std::size_t i = 0; i < layers.size(); ++i) AddToFrame(frame, rows[i + 1], 0, layers[i].channels);
    file.setFrameBuffer(frame);
    for (int y = image.Height() - 1; y >= 0; --y) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const Image& source = i == 0 ? image : layers[i - 1].image;
        const auto first =
            source.Channels().begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row_floats);
        std::copy_n(first, row_floats, rows[i].begin());
      }
      file.writePixels(1);
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR cannot be written: " + Printable(error.what()));
  }
  return stream.Take();
}

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding&, const ImageSettings& settings) {
  return EncodeLayers(image, {}, settings);
}

}  // namespace
}  // namespace exr

const ImageFormat exr_format{"exr",       {"exr"}, exr::Recognizes,   exr::ReadSize,    exr::Decode,
                             exr::Encode, true,    exr::EncodeLayers, exr::ReadSettings};

}  // namespace R2
