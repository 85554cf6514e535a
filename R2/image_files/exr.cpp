// Omits the table of all halves, 256 KiB that would be copied at every program start.
#define IMATH_HALF_NO_LOOKUP_TABLE
#include <ImathVec.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfRgbaYca.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>
#include <OpenEXRConfig.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "R2/image_files/ExrLayout.h"
#include "R2/image_files/formats.h"

// OpenEXR through its library: channels R G B, Y RY BY for luminance and chroma, or Y for gray, of a single flat part,
// of any pixel type, in scan lines or tiles. The image is the display window: black where the data window does not
// cover it; stored pixels outside of it are skipped, and so is alpha. Written as float scan lines, ZIP compressed.
// Settings are stored in string attributes.
// source: Kainz, Bogart, Stanczyk, Hillman, Technical Introduction to OpenEXR (2013); OpenEXR File Layout (2013)
namespace R2 {

namespace exr {
namespace {

// Prepended to our own keys, since a bare "channels" or "type" would be taken for the format's own attribute.
constexpr std::string_view settings_prefix = "raypro:";
constexpr std::size_t longest_name = 255;  // the format's limit

bool Recognizes(std::span<const unsigned char> bytes) {
  constexpr std::array<unsigned char, 4> magic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

ImageSize ReadSize(std::span<const unsigned char> bytes) { return ReadExrLayout(bytes).display.size; }

/// The bytes of a file as a stream for the library.
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

constexpr std::array color_channels{"R", "G", "B"}, chroma_channels{"RY", "Y", "BY"};
constexpr std::array gray_channel{"Y"};

/// Adds one row of r g b floats, whose first pixel is at x = `x_min`, to the library's frame for any y. A single
/// channel takes the place of r.
template <typename Names>
void AddToFrame(Imf::FrameBuffer& frame, std::vector<float>& row, int x_min, const Names& channels) {
  constexpr std::size_t pixel_bytes = 3 * sizeof(float);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    // The library adds x * pixel_bytes again. Computed as integers, because the address x_min pixels before the row is
    // not valid memory.
    const auto address = reinterpret_cast<std::intptr_t>(row.data() + i) -
                         static_cast<std::intptr_t>(x_min) * static_cast<std::intptr_t>(pixel_bytes);
    frame.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(address), pixel_bytes, 0));
  }
}

/// Makes text of the library printable: attribute names in its messages come from the file, and may contain anything.
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

/// Returns the intersection of two windows.
ExrWindow InBoth(const ExrWindow& a, const ExrWindow& b) {
  ExrWindow both{std::max(a.left, b.left), std::max(a.top, b.top), {}};
  both.size.width = static_cast<int>(std::max<std::int64_t>(0, std::min(a.Right(), b.Right()) - both.left));
  both.size.height = static_cast<int>(std::max<std::int64_t>(0, std::min(a.Bottom(), b.Bottom()) - both.top));
  return both;
}

/// Returns the names of the first few channels.
std::string NamesOf(const Imf::ChannelList& channels) {
  constexpr int most_names = 6;
  std::string names;
  int count = 0;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel, ++count)
    if (count < most_names) names += (names.empty() ? "" : ", ") + Printable(channel.name());
  return names + (count > most_names ? " and " + std::to_string(count - most_names) + " more" : "");
}

/// Returns the channels to use as r, g and b; a single one gives gray. Luminance with chroma is converted by
/// ConvertChroma.
std::span<const char* const> ChannelsToRead(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  if (std::ranges::all_of(color_channels, has)) return color_channels;
  if (std::ranges::all_of(chroma_channels, has)) return chroma_channels;
  if (has(gray_channel[0])) return gray_channel;
  throw ImageError("EXR has neither the channels R, G and B nor Y; it has " + NamesOf(channels));
}

/// Reads the display window, with the colors of the stored pixels.
///   read_line   reads one line of the file
///   color_at    the color of a pixel of the line last read, counted from the left end of the data window
template <typename ReadLine, typename ColorAt>
Image ImageOfLines(const ExrLayout& layout, const ReadLine& read_line, const ColorAt& color_at) {
  const ExrWindow &data = layout.data, &display = layout.display, read = InBoth(data, display);
  // The image is allocated only after its first row was read, since the header alone may claim any size.
  Image image;
  for (std::int64_t line = read.top; line < read.Bottom(); ++line) {
    try {
      read_line(static_cast<int>(line));
    } catch (const std::exception& error) {
      throw ImageError("EXR is truncated or damaged: " + std::to_string(line - data.top) + " of " +
                       std::to_string(data.size.height) + " rows are present: " + Printable(error.what()));
    }
    if (image.Width() == 0) image = Image(display.size.width, display.size.height);
    const int y = static_cast<int>(display.Bottom() - 1 - line);
    for (std::int64_t x = read.left; x < read.Right(); ++x)
      image.Set(static_cast<int>(x - display.left), y, color_at(static_cast<std::size_t>(x - data.left)));
  }
  return image.Width() > 0 ? std::move(image) : Image(display.size.width, display.size.height);
}

/// Adds up to three channels as r, g and b; a single one gives gray.
template <typename Names>
Image ReadPixels(Imf::InputFile& file, const ExrLayout& layout, const Names& channels) {
  const bool is_gray = channels.size() == 1, has_blue = channels.size() > 2;
  std::vector<float> row(3 * static_cast<std::size_t>(layout.data.size.width));
  Imf::FrameBuffer frame;
  AddToFrame(frame, row, static_cast<int>(layout.data.left), channels);
  file.setFrameBuffer(frame);
  return ImageOfLines(
      layout, [&](int line) { file.readPixels(line, line); },
      [&](std::size_t x) {
        const float* p = &row[3 * x];
        return Color{p[0], p[is_gray ? 0 : 1], is_gray ? p[0] : has_blue ? p[2] : 0};
      });
}

/// Returns true if chroma has one sample per `step` pixels in every `step`-th row.
bool HasChromaOf(const Imf::ChannelList& channels, int step) {
  return std::ranges::all_of(std::array{"RY", "BY"}, [&](const char* name) {
    const Imf::Channel& channel = *channels.findChannel(name);
    return channel.xSampling == step && channel.ySampling == step;
  });
}

Imf::Chromaticities ChromaticitiesOf(const Imf::Header& header) {
  return Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
}

/// Converts luminance Y and chroma, RY = (R - Y) / Y and BY = (B - Y) / Y, which the image stores as r, g and b in the
/// order RY, Y, BY, to colors. The weights of luminance are those of the file's primaries.
void ConvertChroma(Image& image, const Imf::Header& header) {
  const Imath::V3f weights = Imf::RgbaYca::computeYw(ChromaticitiesOf(header));
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const auto [ry, luminance, by] = image.At(x, y);
      const double r = (ry + 1) * luminance, b = (by + 1) * luminance;
      image.Set(x, y, {r, (luminance - weights.x * r - weights.z * b) / weights.y, b});
    }
}

/// Reads chroma sampled at every second pixel of every second row, filtered as by the library's own readers. It
/// computes with halves, which such images consist of.
Image ReadSampledChroma(std::span<const unsigned char> bytes, const ExrLayout& layout) {
  InputStream stream(bytes);
  Imf::RgbaInputFile file(stream, 0);
  std::vector<Imf::Rgba> row(static_cast<std::size_t>(layout.data.size.width));
  // The address of the pixel at x = 0, which is not valid memory; see AddToFrame.
  const auto address = reinterpret_cast<std::intptr_t>(row.data()) -
                       static_cast<std::intptr_t>(layout.data.left) * static_cast<std::intptr_t>(sizeof(Imf::Rgba));
  file.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(address), 1, 0);
  return ImageOfLines(
      layout, [&](int line) { file.readPixels(line); },
      [&](std::size_t x) {
        return Color{row[x].r, row[x].g, row[x].b};
      });
}

Image ReadColors(Imf::InputFile& file, std::span<const unsigned char> bytes, const ExrLayout& layout) {
  const Imf::ChannelList& channels = file.header().channels();
  const auto to_read = ChannelsToRead(channels);
  const bool has_chroma = to_read.data() == chroma_channels.data();
  if (!has_chroma) return ReadPixels(file, layout, to_read);
  if (HasChromaOf(channels, 2)) return ReadSampledChroma(bytes, layout);
  if (!HasChromaOf(channels, 1))
    throw ImageError(
        "EXR has chroma that is sampled otherwise than for every pixel or every second one in both directions");
  Image image = ReadPixels(file, layout, to_read);
  ConvertChroma(image, file.header());
  return image;
}

/// Rejects a compression that this version of the library does not know, by name.
void RefuseUnknownCompression(int compression) {
  if (compression < Imf::NUM_COMPRESSION_METHODS) return;
  constexpr int first_name = 10;
  constexpr std::array newer{"HTJ2K256", "HTJ2K32", "LJ2K", "ZSTD"};
  const auto index = static_cast<std::size_t>(std::max(compression - first_name, 0));
  const std::string name = index < newer.size() ? std::string(" (") + newer[index] + ")" : "";
  throw ImageError("EXR is compressed by method " + std::to_string(compression) + name +
                   ", which the library of this build, OpenEXR " OPENEXR_VERSION_STRING
                   ", does not know; save it with another, such as ZIP");
}

/// Returns true if the file states primaries other than those of sRGB, which all other images have.
bool HasOtherPrimaries(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return false;
  constexpr float rounding = 0.0006f;  // of the three digits that files contain
  const Imf::Chromaticities usual, stated = Imf::chromaticities(header);
  const auto are_near = [&](const Imath::V2f& a, const Imath::V2f& b) {
    return std::abs(a.x - b.x) < rounding && std::abs(a.y - b.y) < rounding;
  };
  return !are_near(stated.red, usual.red) || !are_near(stated.green, usual.green) ||
         !are_near(stated.blue, usual.blue) || !are_near(stated.white, usual.white);
}

/// Opens the file, and rewords the library's errors.
///   read   Imf::InputFile&, DecodedImage&: fills in the image
template <typename Read>
DecodedImage DecodeWith(std::span<const unsigned char> bytes, const ExrLayout& layout, const Read& read) {
  RefuseUnknownCompression(layout.compression);
  const std::uint64_t end = CheckExrBlocks(bytes, layout);
  try {
    InputStream stream(bytes);
    Imf::InputFile file(stream, 0);  // no library threads
    DecodedImage decoded;
    decoded.settings = SettingsOf(file.header());
    read(file, decoded);
    if (!layout.has_smaller_copies) WarnOfBytesBehind(decoded, "EXR", bytes.size() - end);
    return decoded;
  } catch (const ImageError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw ImageError("EXR is damaged: " + Printable(error.what()));
  }
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  const ExrLayout layout = ReadExrLayout(bytes);
  return DecodeWith(bytes, layout, [&](Imf::InputFile& file, DecodedImage& decoded) {
    decoded.image = ReadColors(file, bytes, layout);
    if (HasOtherPrimaries(file.header()))
      decoded.warnings.push_back(
          "EXR states its own chromaticities; its colors are interpreted as linear sRGB");
  });
}

ImageWindow WindowOf(const ExrWindow& window) {
  return {window.left, window.top, window.Right() - 1, window.Bottom() - 1};
}

ImageChannels ReadChannelNames(std::span<const unsigned char> bytes) {
  const ExrLayout layout = ReadExrLayout(bytes);
  ImageChannels all{.channels = {}, .data = WindowOf(layout.data), .display = WindowOf(layout.display)};
  for (const ExrChannel& channel : layout.channels) all.channels.push_back({channel.name, channel.type});
  return all;
}

/// Warns of integers beyond 2^24, not all of which are floats.
void WarnOfRoundedNumbers(DecodedImage& decoded) {
  constexpr float first_rounded = 16'777'216;
  if (std::ranges::any_of(decoded.image.Channels(), [](float number) { return number >= first_rounded; }))
    decoded.warnings.push_back("EXR has whole numbers of 16777216 or more, which are rounded");
}

DecodedImage DecodeChannels(std::span<const unsigned char> bytes, std::span<const std::string> names) {
  const ExrLayout layout = ReadExrLayout(bytes);
  bool has_whole_numbers = false;
  std::vector<const char*> channels;
  for (const std::string& name : names) {
    const auto channel = std::ranges::find(layout.channels, name, &ExrChannel::name);
    if (channel == layout.channels.end()) throw ImageError("EXR has no channel " + Printable(name));
    if (channel->x_sampling != 1 || channel->y_sampling != 1)
      throw ImageError("EXR has a channel " + Printable(name) + " that does not have a sample for every pixel");
    has_whole_numbers = has_whole_numbers || channel->type == ImageChannel::Type::uint32;
    channels.push_back(name.c_str());
  }
  return DecodeWith(bytes, layout, [&](Imf::InputFile& file, DecodedImage& decoded) {
    decoded.image = ReadPixels(file, layout, channels);
    if (has_whole_numbers) WarnOfRoundedNumbers(decoded);
  });
}

/// Reads the settings from the header alone: opening the file by the library would allocate rows as wide as the header
/// claims.
ImageSettings ReadSettings(std::span<const unsigned char> bytes) {
  constexpr std::uint64_t behind_version = 8;
  ReadExrLayout(bytes);
  try {
    InputStream stream(bytes);
    stream.seekg(behind_version);
    Imf::Header header;
    int version = Imf::EXR_VERSION;
    header.readFrom(stream, version);
    return SettingsOf(header);
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

extern const ImageFormat exr_format{
    "exr", {"exr"},           exr::Recognizes,   exr::ReadSize,         exr::Decode,        exr::Encode,
    true,  exr::EncodeLayers, exr::ReadSettings, exr::ReadChannelNames, exr::DecodeChannels};

}  // namespace R2
