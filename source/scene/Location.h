#pragma once

#include <cstdint>

namespace ray {

/// A place in the text a scene was read from.
struct Location {
  std::uint32_t file = 0;    // index into Scene::files
  std::uint32_t line = 0;    // from 1; 0 means "no place": made by the program itself
  std::uint32_t column = 0;  // from 1, in characters
};

}  // namespace ray
