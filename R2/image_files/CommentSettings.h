#pragma once

#include <string>
#include <string_view>

#include "R2/ImageFile.h"

/// Settings as human-readable text, one line of "key: value" each.
namespace R2 {

std::string CommentText(const ImageSettings& settings);

/// Parses such text. Lines of other programs without a key are stored under "comment".
ImageSettings SettingsOfComment(std::string_view text);

}  // namespace R2
