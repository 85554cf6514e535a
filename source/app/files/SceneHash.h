#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ray {

/// Returns 16 hexadecimal digits that identify a version of a scene: the Hash of the bytes of its files in order. A
/// missing file counts as empty.
/// `texts`: the edited text of the first files, used in place of those on disk.
std::string SceneHash(std::span<const std::string> files, std::span<const std::string_view> texts = {});

}  // namespace ray
