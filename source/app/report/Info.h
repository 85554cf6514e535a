#pragma once

#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace ray {

/// Throws SceneErrors when it is missing.
std::vector<unsigned char> ReadBytes(const std::string& file);
/// Throws SceneErrors, which name the file, when the bytes are no picture. Its warnings are left to the caller.
R2::DecodedImage DecodePicture(const std::string& file, std::span<const unsigned char> bytes);
/// Reads and decodes a picture, and prints its warnings.
R2::DecodedImage ReadPicture(const std::string& file);

/// "out.png: png, 512x512" and a line for each setting kept in the picture.
std::string PictureText(const std::string& file, const R2::ImageHeader& picture);

/// What -info prints: size and format of a picture and the settings kept in it. Throws SceneErrors when it is missing
/// or no picture.
std::string PictureInfo(const std::string& file);

}  // namespace ray
