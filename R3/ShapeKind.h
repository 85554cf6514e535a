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

/// One number on a line of a scene file, belonging to a shape or a light.
struct Argument {
  const char* name;  // "radius"
  bool may_be_negative = true;
};

/// Makes a list of arguments from their names.
template <typename... Name>
constexpr std::array<Argument, sizeof...(Name)> ArgumentsNamed(Name... names) {
  return {Argument{names}...};
}
/// Makes a list of nonnegative arguments from their names.
template <typename... Name>
constexpr std::array<Argument, sizeof...(Name)> ArgumentsFromZero(Name... names) {
  return {Argument{names, false}...};
}

/// An invalid number; the reader of the scene file turns it into an error that points to it.
struct ArgumentError : std::runtime_error {
  ArgumentError(std::size_t which, const std::string& message) : std::runtime_error(message), index(which) {}
  std::size_t index;  // into the arguments
};

/// One line of shapes.def: the description of a kind for the parser, the help and the tests over every shape.
struct ShapeKind {
  const char* name;                 // the word in a scene file
  const char* about;                // one line of help
  std::vector<Argument> arguments;  // in file order
  /// Makes a shape. The number of `arguments` is as above; they are finite with the required signs. May throw
  /// ArgumentError.
  std::unique_ptr<const Shape> (*make)(std::span<const double> arguments);
  std::vector<double> example;  // a typical shape: bounded, hit by a ray from afar towards its center
  std::size_t repeated = 0;     // the number of last arguments that may be repeated together any number of times

  bool Takes(std::size_t count) const {
    if (count == arguments.size() || repeated == 0) return count == arguments.size();
    return count > arguments.size() && (count - arguments.size()) % repeated == 0;
  }
};

/// Returns all kinds that are described by numbers alone, in the order of shapes.def.
std::span<const ShapeKind* const> ShapeKinds();
/// Returns the kind with the given name, or null.
const ShapeKind* FindShapeKind(const std::string& name);
/// Makes a shape, for tests and programs: asserts that the name exists and the count fits.
std::unique_ptr<const Shape> MakeShape(const std::string& name, std::vector<double> arguments);

}  // namespace R3
