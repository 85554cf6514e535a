#pragma once

#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/film/PixelRectangle.h"

namespace ray {

/// Returns the contents of a file that the user named; throws SceneErrors if it cannot be read.
std::string Contents(const std::string& name);

/// Returns the images of -reference, none to two. Throws SceneErrors if one cannot be read, UsageError if its size is
/// not that of the region to be rendered.
std::vector<R2::Image> ReadReferences(const std::vector<std::string>& names, const PixelRectangle& region);

}  // namespace ray
