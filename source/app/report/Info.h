#pragma once

#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace ray {

/// Returns the bytes of a file. Throws SceneErrors if it is missing.
std::vector<unsigned char> ReadBytes(const std::string& file);
/// Decodes an image. Throws SceneErrors with the file's name if the bytes are not an image. Its warnings are left to
/// the caller.
R2::DecodedImage DecodeImageFile(const std::string& file, std::span<const unsigned char> bytes);
/// Reads and decodes an image, and prints its warnings.
R2::DecodedImage ReadImageFile(const std::string& file);

/// Returns "out.png: png, 512x512" and a line for each setting stored in the image.
std::string ImageText(const std::string& file, const R2::ImageHeader& header);

/// Returns the text of -info: size and format of an image and the settings stored in it. Throws SceneErrors if it is
/// missing or not an image.
std::string ImageInfo(const std::string& file);

}  // namespace ray
