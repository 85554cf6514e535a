#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace R3 {

/// One number on a line of a scene file: of a shape or of a light.
struct Argument {
  const char* name;  // "radius"
  bool may_be_negative = true;
};

/// A number that is wrong for its place; the reader of the scene file turns it into an error that points there.
struct ArgumentError : std::runtime_error {
  ArgumentError(std::size_t which, const std::string& message) : std::runtime_error(message), index(which) {}
  std::size_t index;  // into the arguments
};

}  // namespace R3
