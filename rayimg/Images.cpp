#include "rayimg/Images.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "R2/ToneCurve.h"
#include "source/app/Status.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"

namespace ray::rayimg {
namespace {

std::string SizeOf(const std::string& name, const R2::Image& image) {
  return Quoted(name) + " has " + std::to_string(image.Width()) + "x" + std::to_string(image.Height()) + " pixels";
}

}  // namespace

R2::DecodedImage ReadLight(const std::string& file, bool srgb) {
  R2::DecodedImage decoded = ReadImageFile(file);
  if (!srgb || decoded.format->is_linear) return decoded;
  R2::Image& image = decoded.image;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, R2::DecodeSrgb(image.At(x, y)));
  return decoded;
}

void Expose(R2::Image& image, const ImageOptions& options) {
  const double factor = R1::Exp2(options.exposure);
  const R2::ToneCurve& curve =
      *std::ranges::find_if(R2::ToneCurves(), [&](const R2::ToneCurve& one) { return options.tonemap == one.name; });
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, Apply(curve, factor * image.At(x, y)));
}

void RefuseOtherSize(const std::string& a_name, const R2::Image& a, const std::string& b_name, const R2::Image& b) {
  if (a.Width() == b.Width() && a.Height() == b.Height()) return;
  throw UsageError("images must have one size, but " + SizeOf(a_name, a) + " and " + SizeOf(b_name, b));
}

void Write(const ImageOutput& output, const R2::Image& image, const R2::ImageEncoding& encoding,
           const R2::ImageSettings& settings) {
  RefuseSize(*output.format, image.Width(), image.Height());
  if (output.file.is_link)
    PrintError("rayimg: " + Quoted(output.file.name) + " is a link; the image goes to " +
               QuotedPath(output.file.target.string()));
  WriteWhole(output.file, output.format->encode(image, encoding, settings));
}

void RefuseToRound(const std::string& name, bool is_linear, const ImageOutput& output) {
  if (!is_linear || output.format->is_linear) return;
  std::string keep;
  for (const R2::ImageFormat& format : R2::ImageFormats())
    if (format.is_linear) keep += (keep.empty() ? "." : ", .") + std::string(format.extensions[0]);
  throw UsageError(Quoted(name) + " contains floats, but a " + output.format->name +
                   " stores only quantized values from 0 to 1; write one of " + keep +
                   ", or map the values by rayimg convert");
}

R2::ImageEncoding EncodingOf(const ImageOptions& options, const ImageOutput& output) {
  if (options.bits == 16 && std::string(output.format->name) != "png")
    throw UsageError("-bits 16 needs a PNG, not " + std::string(output.format->name));
  return {.srgb = options.srgb, .bits = options.bits, .jpeg_quality = options.jpeg_quality};
}

void RefuseTooManyPixels(std::int64_t width, std::int64_t height) {
  if (width <= R2::max_pixels / height) return;
  throw UsageError(std::to_string(width) + "x" + std::to_string(height) + " pixels are more than the limit of " +
                   std::to_string(R2::max_pixels));
}

void AddCommand(R2::ImageSettings& settings, const std::string& command_line) {
  std::string& converted = settings["converted"];
  converted += (converted.empty() ? "" : "; ") + command_line;
}

std::string Rounded(double number) {
  return std::isnan(number) ? "nan" : ray::Rounded(number, 6);  // the sign carries no information
}

}  // namespace ray::rayimg
