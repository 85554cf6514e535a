#pragma once

#include <string>
#include <string_view>

#include "R2/ImageFile.h"

/// Conversions for the text chunks of PNG.
namespace R2 {

/// Converts Latin-1, the encoding of plain text chunks, to UTF-8.
std::string Utf8OfLatin1(std::string_view text);

/// Returns the settings in a form that PNG can store: a key that is not a valid keyword is written before its value in
/// a comment.
ImageSettings WritableAsPng(const ImageSettings& settings);

}  // namespace R2
