#pragma once

#include <string>

namespace ray {

/// What -info prints: size and format of a picture and the settings kept in it. Throws SceneErrors when it is missing
/// or no picture.
std::string PictureInfo(const std::string& file);

}  // namespace ray
