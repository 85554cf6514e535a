#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ray {

/// Returns the name of an enumerator on the command line, in messages and in reports. NamesOf(value), declared with the
/// enum type, is the table of names in the order of the enumerators.
template <class Enum>
constexpr const char* NameOf(Enum value) {
  return NamesOf(value)[static_cast<std::size_t>(value)];
}

/// Returns the enumerator with the given name, or std::nullopt.
template <class Enum>
constexpr std::optional<Enum> Named(std::string_view name) {
  const auto& names = NamesOf(Enum{});
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Enum>(i);
  return {};
}

}  // namespace ray
