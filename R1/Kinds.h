#pragma once

#include <span>
#include <string_view>

/// The address of a kind that another file of the namespace defines. A table lists its kinds in a .def file, one per
/// line:|    #define SHAPE(name) KIND(ShapeKind, name##_kind),
#define KIND(Type, name)    \
  [] {                      \
    extern const Type name; \
    return &name;           \
  }()

namespace R1 {

/// Returns the kind with the given name, or null.
template <class Kind>
const Kind* FindKind(std::span<const Kind* const> kinds, std::string_view name) {
  for (const Kind* kind : kinds)
    if (name == kind->name) return kind;
  return nullptr;
}

}  // namespace R1
