#include "source/app/files/ReadInputs.h"

#include "source/app/Status.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

R2::Image ReadReference(const std::string& name) {
  const std::string bytes = Contents(name);
  try {
    return R2::DecodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}).image;
  } catch (const R2::ImageError& error) {
    throw SceneErrors({ErrorIn(name, error.what())});
  }
}

PixelRectangle PartOf(const RenderSettings& render) {
  return render.crop.value_or(PixelRectangle{0, 0, render.width, render.height});
}

std::string SizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

}  // namespace

std::string Contents(const std::string& name) {
  try {
    const Files files(name, {});
    return files.Read(files.Top());
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(name, error.message)});
  }
}

std::vector<R2::Image> ReadReferences(const Options& options) {
  const PixelRectangle part = PartOf(options.render);
  std::vector<R2::Image> references;
  for (const std::string& name : options.reference) {
    references.push_back(ReadReference(name));
    const R2::Image& image = references.back();
    if (image.Width() != part.Width() || image.Height() != part.Height())
      throw UsageError("the reference " + Quoted(name) + " is " + SizeText(image.Width(), image.Height()) +
                       ", the picture " + SizeText(part.Width(), part.Height()));
  }
  return references;
}

}  // namespace ray
