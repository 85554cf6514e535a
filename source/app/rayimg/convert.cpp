#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "R2/ToneCurve.h"
#include "source/app/Status.h"
#include "source/app/rayimg/Commands.h"
#include "source/app/rayimg/Pictures.h"

namespace ray::rayimg {
namespace {

const R2::ToneCurve& Curve(const std::string& name) {
  return *std::ranges::find_if(R2::ToneCurves(), [&](const R2::ToneCurve& curve) { return name == curve.name; });
}

/// Of a picture that is converted twice, both times are told.
void AddTo(R2::ImageSettings& settings, const std::string& command_line) {
  std::string& told = settings["converted"];
  told += (told.empty() ? "" : "; ") + command_line;
}

}  // namespace

int Convert(const Options& options, const std::string& command_line) {
  const std::string& in = options.names[0];
  const std::string inputs[] = {in};
  const PictureOutput output = CheckPictureOutput(options.names[1], inputs);
  if (options.bits == 16 && std::string(output.format->name) != "png")
    throw UsageError("-bits 16 needs a PNG, not " + std::string(output.format->name));

  R2::DecodedImage picture = ReadLight(in, options.srgb);
  const double factor = R1::Exp2(options.exposure);
  const R2::ToneCurve& curve = Curve(options.tonemap);
  R2::Image& image = picture.image;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, Apply(curve, factor * image.At(x, y)));

  AddTo(picture.settings, command_line);
  Write(output, image, {.srgb = options.srgb, .bits = options.bits, .jpeg_quality = options.jpeg_quality},
        picture.settings);
  return status::done;
}

}  // namespace ray::rayimg
