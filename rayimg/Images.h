#pragma once

#include <string>

#include "R2/ImageFile.h"
#include "rayimg/Options.h"
#include "source/app/files/Outputs.h"

namespace ray::rayimg {

/// Reads an image; with `srgb` the values of 8 and 16 bit formats are decoded to linear light. Throws SceneErrors if it
/// is missing or not an image.
R2::DecodedImage ReadLight(const std::string& file, bool srgb);

/// Applies -exposure and -tonemap.
void Expose(R2::Image& image, const ImageOptions& options);

/// Throws UsageError unless both have the same size.
void RefuseOtherSize(const std::string& a_name, const R2::Image& a, const std::string& b_name, const R2::Image& b);

/// Writes the image. Throws UsageError if the format cannot store it, and OutputError.
void Write(const ImageOutput& output, const R2::Image& image, const R2::ImageEncoding& encoding,
           const R2::ImageSettings& settings);

/// Throws UsageError if a float image would be written to an 8-bit format, which clamps and rounds it.
///   is_linear   true for a float image
void RefuseToRound(const std::string& name, bool is_linear, const ImageOutput& output);

/// Returns the encoding given by -srgb, -bits and -jpeg_quality. Throws UsageError if the format has no 16 bits.
R2::ImageEncoding EncodingOf(const ImageOptions& options, const ImageOutput& output);

/// Throws UsageError if an image would have more than R2::max_pixels.
void RefuseTooManyPixels(std::int64_t width, std::int64_t height);

/// Adds the command to the image's history.
void AddCommand(R2::ImageSettings& settings, const std::string& command_line);

/// Formats a number with six digits.
std::string Rounded(double number);

}  // namespace ray::rayimg
