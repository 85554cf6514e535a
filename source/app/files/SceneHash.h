#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ray {

/// 16 hexadecimal digits that tell one version of a scene from another: the bytes of the files it was read from, one
/// after the other, hashed by Hash. A file that is gone counts as empty.
/// `texts`: of the first files, as a viewer that edits them has them, in place of those of the disk.
std::string SceneHash(std::span<const std::string> files, std::span<const std::string_view> texts = {});

}  // namespace ray
