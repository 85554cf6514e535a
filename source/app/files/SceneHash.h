#pragma once

#include <span>
#include <string>

namespace ray {

/// 16 hexadecimal digits that tell one version of a scene from another: the bytes of the files it was read from, one
/// after the other, hashed by Hash. A file that is gone counts as empty.
std::string SceneHash(std::span<const std::string> files);

}  // namespace ray
