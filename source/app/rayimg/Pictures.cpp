#include "source/app/rayimg/Pictures.h"

#include <cmath>

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
  R2::DecodedImage picture = ReadPicture(file);
  if (!srgb || picture.format->is_linear) return picture;
  R2::Image& image = picture.image;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, R2::DecodeSrgb(image.At(x, y)));
  return picture;
}

void RefuseOtherSize(const std::string& a_name, const R2::Image& a, const std::string& b_name, const R2::Image& b) {
  if (a.Width() == b.Width() && a.Height() == b.Height()) return;
  throw UsageError("pictures must have one size, but " + SizeOf(a_name, a) + " and " + SizeOf(b_name, b));
}

void Write(const PictureOutput& output, const R2::Image& image, const R2::ImageEncoding& encoding,
           const R2::ImageSettings& settings) {
  RefuseSize(*output.format, image.Width(), image.Height());
  if (output.file.is_link)
    PrintError("rayimg: " + Quoted(output.file.name) + " is a link; the picture goes to " +
               QuotedPath(output.file.target.string()));
  WriteWhole(output.file, output.format->encode(image, encoding, settings));
}

std::string Rounded(double number) {
  return std::isnan(number) ? "nan" : ray::Rounded(number, 6);  // whose sign says nothing
}

}  // namespace ray::rayimg
