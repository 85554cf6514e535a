#pragma once

#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/film/PixelRectangle.h"

namespace ray {

/// The whole of a file that the user names; throws SceneErrors where it cannot be read.
std::string Contents(const std::string& name);

/// The images of -reference, none to two. Throws SceneErrors when one cannot be read, UsageError when its size is not
/// that of the region to be rendered.
std::vector<R2::Image> ReadReferences(const std::vector<std::string>& names, const PixelRectangle& region);

}  // namespace ray
