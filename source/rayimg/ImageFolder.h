#pragma once

#include <string>
#include <vector>

namespace ray::rayimg {

/// The files in a folder whose names end as images do, sorted; not those of folders within it. Throws SceneErrors when
/// it cannot be read, and UsageError when it holds no image.
std::vector<std::string> ImagesIn(const std::string& folder);

}  // namespace ray::rayimg
