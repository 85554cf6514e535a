#include "source/app/files/ReadInputs.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "source/app/Status.h"
#include "source/app/report/Messages.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

std::string SizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// Reads a reference. Wrong sizes are rejected by the header, since a small file can contain a large image.
R2::Image ReadReference(const std::string& name, const PixelRectangle& part) {
  const std::string text = Contents(name);
  const std::span bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  try {
    const R2::ImageSize size = R2::ReadImageSize(bytes);
    if (size.width != part.Width() || size.height != part.Height())
      throw UsageError("the reference " + Quoted(name) + " is " + SizeText(size.width, size.height) + ", the image " +
                       SizeText(part.Width(), part.Height()));
    R2::DecodedImage decoded = R2::DecodeImage(bytes);
    PrintWarnings(name, decoded.warnings);
    return std::move(decoded.image);
  } catch (const R2::ImageError& error) {
    throw SceneErrors({ErrorIn(name, error.what())});
  }
}

}  // namespace

std::string Contents(const std::string& name) {
  try {
    const Files files(name, {});
    return files.Read(files.Top());
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(name, error.message, error.hint)});
  }
}

std::vector<R2::Image> ReadReferences(const std::vector<std::string>& names, const PixelRectangle& region) {
  std::error_code ignored;
  if (names.size() == 2 && std::filesystem::equivalent(names[0], names[1], ignored))
    throw UsageError("-reference takes two independent images, and " + Quoted(names[0]) + " and " + Quoted(names[1]) +
                     " are the same file");
  std::vector<R2::Image> references;
  for (const std::string& name : names) references.push_back(ReadReference(name, region));
  return references;
}

}  // namespace ray
