#pragma once

#include <string>

#include "R2/ImageFile.h"
#include "source/app/files/Outputs.h"
#include "source/rayimg/Options.h"

namespace ray::rayimg {

/// Reads a picture; with `srgb` the values of 8 and 16 bit kinds are decoded to light. Throws SceneErrors when it is
/// missing or no picture.
R2::DecodedImage ReadLight(const std::string& file, bool srgb);

/// Makes a picture brighter and applies a tone curve, as -exposure and -tonemap ask.
void Expose(R2::Image& image, const ImageOptions& options);

/// Throws UsageError unless both are as wide and as high.
void RefuseOtherSize(const std::string& a_name, const R2::Image& a, const std::string& b_name, const R2::Image& b);

/// Throws UsageError when the format cannot hold the picture, and OutputError.
void Write(const PictureOutput& output, const R2::Image& image, const R2::ImageEncoding& encoding,
           const R2::ImageSettings& settings);

/// Throws UsageError where a picture of floats would go into a format of bytes, which clamps and rounds them.
///   is_linear   whether the picture is one of floats
void RefuseToRound(const std::string& name, bool is_linear, const PictureOutput& output);

/// The encoding that -srgb, -bits and -jpeg_quality ask for. Throws UsageError where the format has no 16 bits.
R2::ImageEncoding EncodingOf(const ImageOptions& options, const PictureOutput& output);

/// Throws UsageError where an image would have more than R2::max_pixels.
void RefuseTooManyPixels(std::int64_t width, std::int64_t height);

/// Adds the command to those that the picture has been through.
void AddCommand(R2::ImageSettings& settings, const std::string& command_line);

/// Six digits, for people.
std::string Rounded(double number);

}  // namespace ray::rayimg
