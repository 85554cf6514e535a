#pragma once

#include <string>
#include <vector>

namespace R3 {

/// What makes a shape or a light again, as a line of a scene file: the name of its kind, and the kind's arguments in
/// file order. Made again it is the same to the bit.
struct Recipe {
  const char* kind;
  std::vector<double> arguments;
  std::string text{};  // that comes before them, as a formula
};

}  // namespace R3
