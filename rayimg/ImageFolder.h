#pragma once

#include <string>
#include <vector>

namespace ray::rayimg {

/// Returns the files in a folder with an image extension, sorted; without those of subfolders. Throws SceneErrors if
/// the folder cannot be read, and UsageError if it contains no image.
std::vector<std::string> ImagesIn(const std::string& folder);

}  // namespace ray::rayimg
