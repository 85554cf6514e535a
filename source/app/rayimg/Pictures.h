#pragma once

#include <string>

#include "R2/ImageFile.h"
#include "source/app/files/Outputs.h"

namespace ray::rayimg {

/// Reads a picture; with `srgb` the values of 8 and 16 bit kinds are decoded to light. Throws SceneErrors when it is
/// missing or no picture.
R2::DecodedImage ReadLight(const std::string& file, bool srgb);

/// Throws UsageError unless both are as wide and as high.
void RefuseOtherSize(const std::string& a_name, const R2::Image& a, const std::string& b_name, const R2::Image& b);

/// Throws UsageError when the format cannot hold the picture, and OutputError.
void Write(const PictureOutput& output, const R2::Image& image, const R2::ImageEncoding& encoding,
           const R2::ImageSettings& settings);

/// Six digits, for people.
std::string Rounded(double number);

}  // namespace ray::rayimg
