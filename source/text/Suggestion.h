#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ray {

/// The choice that a word was probably meant to be, or nothing. A third of its letters may be wrong, whatever their
/// case.
std::string_view Nearest(std::string_view word, std::span<const std::string_view> choices);

/// A hint behind a word that should have been one of `choices`: "did you mean 'sphere'?" when one is close, otherwise
/// "commands are box, ..." with `plural` = "commands".
std::string Suggestion(std::string_view word, std::span<const std::string_view> choices, const std::string& plural);

}  // namespace ray
