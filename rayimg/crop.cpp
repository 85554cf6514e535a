#include <algorithm>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Layers.h"
#include "source/app/Status.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/text/Quoting.h"

namespace ray::rayimg {
namespace {

void RefuseOutside(const std::string& name, const R2::Image& image, const PixelRectangle& c) {
  const bool is_inside = c.x0 >= 0 && c.y0 >= 0 && c.x1 <= image.Width() && c.y1 <= image.Height();
  if (is_inside && c.x0 < c.x1 && c.y0 < c.y1) return;
  const auto number = [](int n) { return " " + std::to_string(n); };
  throw UsageError("-crop" + number(c.x0) + number(c.y0) + number(c.x1) + number(c.y1) + " must lie within " +
                   Quoted(name) + ": 0 <= x0 < x1 <=" + number(image.Width()) +
                   " from the left, 0 <= y0 < y1 <=" + number(image.Height()) + " from the bottom");
}

R2::Image Cropped(const R2::Image& image, const PixelRectangle& crop) {
  R2::Image cropped(crop.Width(), crop.Height());
  for (int y = 0; y < cropped.Height(); ++y)
    for (int x = 0; x < cropped.Width(); ++x) cropped.Set(x, y, image.At(crop.x0 + x, crop.y0 + y));
  return cropped;
}

/// Returns all channels except the color, in groups of up to three.
std::vector<R2::ImageLayer> CroppedLayers(const R2::ImageFormat& format, std::span<const unsigned char> bytes,
                                          const PixelRectangle& crop) {
  constexpr std::size_t most = 3;
  std::vector<R2::ImageLayer> cropped;
  for (const Layer& layer : FurtherLayers(format, bytes)) {
    const std::vector<std::string> names = ChannelNames(layer);
    for (std::size_t i = 0; i < names.size(); i += most) {
      const std::vector<std::string> some(
          names.begin() + static_cast<std::ptrdiff_t>(i),
          names.begin() + static_cast<std::ptrdiff_t>(std::min(i + most, names.size())));
      cropped.push_back({some, Cropped(format.decode_channels(bytes, some).image, crop)});
    }
  }
  return cropped;
}

}  // namespace

int Crop(const ImageOptions& options, const std::string& command_line) {
  const std::string& in = options.names[0];
  const std::string inputs[] = {in};
  const ImageOutput output = CheckImageOutput(options.names[1], inputs);
  const std::vector<unsigned char> bytes = ReadBytes(in);
  R2::DecodedImage decoded = DecodeImageFile(in, bytes);
  PrintWarnings(in, decoded.warnings);
  RefuseToRound(in, decoded.format->is_linear, output);
  RefuseOutside(in, decoded.image, *options.crop);
  AddCommand(decoded.settings, command_line);
  const R2::Image cropped = Cropped(decoded.image, *options.crop);
  if (!output.format->encode_layers) {
    WarnOfFurtherLayers(in);
    Write(output, cropped, EncodingOf(options, output), decoded.settings);
    return status::done;
  }
  try {
    const auto layers = CroppedLayers(*decoded.format, bytes, *options.crop);
    WriteWhole(output.file, output.format->encode_layers(cropped, layers, decoded.settings));
  } catch (const R2::ImageError& error) {
    throw SceneErrors({ErrorIn(in, error.what())});
  }
  return status::done;
}

}  // namespace ray::rayimg
