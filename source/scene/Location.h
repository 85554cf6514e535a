#pragma once

#include <cstdint>

namespace ray {

/// A position in the text from which a scene was read.
struct Location {
  std::uint32_t file = 0;    // index into Scene::files
  std::uint32_t line = 0;    // 1-based; 0 means no position: made by the program itself
  std::uint32_t column = 0;  // 1-based, in characters
};

}  // namespace ray
