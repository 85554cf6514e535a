#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "R3/Shape.h"

namespace R3 {

/// One number on a line of a scene file: of a shape or of a light.
struct Argument {
  const char* name;  // "radius"
  bool may_be_negative = true;
};

/// Makes a list of arguments from their names.
template <typename... Name>
constexpr std::array<Argument, sizeof...(Name)> ArgumentsNamed(Name... names) {
  return {Argument{names}...};
}
/// Likewise, none of them negative.
template <typename... Name>
constexpr std::array<Argument, sizeof...(Name)> ArgumentsFromZero(Name... names) {
  return {Argument{names, false}...};
}

/// A number that is wrong for its place; the reader of the scene file turns it into an error that points there.
struct ArgumentError : std::runtime_error {
  ArgumentError(std::size_t which, const std::string& message) : std::runtime_error(message), index(which) {}
  std::size_t index;  // into the arguments
};

/// One line of shapes.def: what the parser, the help and the tests over every shape know of a kind.
struct ShapeKind {
  const char* name;                 // the word in a scene file
  const char* about;                // one line for the help
  std::vector<Argument> arguments;  // in file order
  /// `arguments` are as many as above, finite, their signs checked; may throw ArgumentError.
  std::unique_ptr<const Shape> (*make)(std::span<const double> arguments);
  std::vector<double> example;  // a typical one: bounded, hit by a ray from afar to its middle
  std::size_t repeated = 0;     // how many of the last arguments may come again together, any number of times

  bool Takes(std::size_t count) const {
    if (count == arguments.size() || repeated == 0) return count == arguments.size();
    return count > arguments.size() && (count - arguments.size()) % repeated == 0;
  }
};

/// All kinds that numbers alone describe, in the order of shapes.def.
std::span<const ShapeKind* const> ShapeKinds();
/// The kind of that name; null if there is none.
const ShapeKind* FindShapeKind(const std::string& name);
/// For tests and programs: asserts that the name exists and the count fits.
std::unique_ptr<const Shape> MakeShape(const std::string& name, std::vector<double> arguments);

}  // namespace R3
