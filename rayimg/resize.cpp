#include "source/film/Resize.h"

#include <algorithm>
#include <cmath>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Layers.h"
#include "source/app/Status.h"

namespace ray::rayimg {
namespace {

/// Returns the new size; a side that is not given follows from the aspect ratio.
R2::ImageSize NewSize(const R2::Image& image, const ImageOptions& options) {
  const auto scaled = [](int side, int named, int other) {
    return std::max(std::int64_t{1},
                    static_cast<std::int64_t>(std::llround(static_cast<double>(side) * named / other)));
  };
  const std::int64_t width = options.width ? *options.width : scaled(image.Width(), *options.height, image.Height());
  const std::int64_t height = options.height ? *options.height : scaled(image.Height(), *options.width, image.Width());
  RefuseTooManyPixels(width, height);
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

int Resize(const ImageOptions& options, const std::string& command_line) {
  const std::string& in = options.names[0];
  const std::string inputs[] = {in};
  const ImageOutput output = CheckImageOutput(options.names[1], inputs);
  R2::DecodedImage decoded = ReadLight(in, options.srgb);
  RefuseToRound(in, decoded.format->is_linear, output);
  const R2::ImageSize size = NewSize(decoded.image, options);
  WarnOfFurtherLayers(in);
  AddCommand(decoded.settings, command_line);
  Write(output, Resized(decoded.image, size.width, size.height, options.filter), EncodingOf(options, output),
        decoded.settings);
  return status::done;
}

}  // namespace ray::rayimg
