#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ray {

/// The word for an enumerator on the command line, in messages and in reports. Its type has the table of them beside
/// it: `NamesOf(value)`, in the order of the enumerators.
template <class Enum>
constexpr const char* NameOf(Enum value) {
  return NamesOf(value)[static_cast<std::size_t>(value)];
}

/// The enumerator of that name, or nothing.
template <class Enum>
constexpr std::optional<Enum> Named(std::string_view name) {
  const auto& names = NamesOf(Enum{});
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Enum>(i);
  return {};
}

}  // namespace ray
