#pragma once

#include <string>
#include <string_view>

#include "R2/ImageFile.h"

/// What the text chunks of PNG can hold.
namespace R2 {

/// Turns Latin-1, which plain text chunks are in, into UTF-8.
std::string Utf8OfLatin1(std::string_view text);

/// The settings as a PNG file can hold them: a key that is no keyword stands before its value in a comment.
ImageSettings WritableAsPng(const ImageSettings& settings);

}  // namespace R2
