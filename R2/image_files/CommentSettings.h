#pragma once

#include <string>
#include <string_view>

#include "R2/ImageFile.h"

/// Settings as text for people, a line of "key: value" each.
namespace R2 {

std::string CommentText(const ImageSettings& settings);

/// The inverse. Lines of another program that have no key are kept under "comment".
ImageSettings SettingsOfComment(std::string_view text);

}  // namespace R2
