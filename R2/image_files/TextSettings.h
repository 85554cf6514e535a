#pragma once

#include <string>
#include <string_view>

#include "R2/ImageFile.h"

/// Settings as text in image files: as chunks of PNG, and as a comment with one line of "key: value" each.
namespace R2 {

/// Converts Latin-1, the encoding of plain text chunks, to UTF-8.
std::string Utf8OfLatin1(std::string_view text);

/// Returns the settings in a form that PNG can store: a key that is not a valid keyword is written before its value in
/// a comment.
ImageSettings WritableAsPng(const ImageSettings& settings);

/// Returns settings as a comment.
std::string CommentText(const ImageSettings& settings);

/// Parses a comment. Lines of other programs without a key are stored under "comment".
ImageSettings SettingsOfComment(std::string_view text);

}  // namespace R2
