#pragma once

#include <span>
#include <string>

namespace ray {

/// 16 hexadecimal digits that tell one version of a scene from another: the bytes of the files it was read from, one
/// after the other. Not made against forgers. A file that is gone counts as empty.
///   source  Fowler, Noll, Vo, Eastlake, The FNV non-cryptographic hash algorithm (2019): FNV-1a, 64 bits
std::string SceneHash(std::span<const std::string> files);

}  // namespace ray
