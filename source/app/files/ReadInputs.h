#pragma once

#include <vector>

#include "source/app/options/Options.h"

namespace ray {

/// The whole of a file that the user names; throws SceneErrors where it cannot be read.
std::string Contents(const std::string& name);

/// The pictures of -reference, none to two. Throws SceneErrors when one cannot be read, UsageError when its size is not
/// that of the picture to be made.
std::vector<R2::Image> ReadReferences(const Options& options);

}  // namespace ray
