#pragma once

#include <string>
#include <vector>

namespace R3 {

/// The line of a scene file that recreates a shape or a light: the name of its kind, and the kind's arguments in file
/// order. The copy is bit-identical.
struct Recipe {
  const char* kind;
  std::vector<double> arguments;
  std::string text{};  // precedes the arguments, as a formula
};

}  // namespace R3
