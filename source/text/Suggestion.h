#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ray {

/// Returns the choice that a word was probably meant to be, or an empty text. Up to a third of its letters may be
/// wrong, ignoring letter case.
std::string_view Nearest(std::string_view word, std::span<const std::string_view> choices);

/// Returns a hint about a word that should have been one of `choices`: "did you mean 'sphere'?" if one is close,
/// otherwise "commands are box, ..." with `plural` = "commands".
std::string Suggestion(std::string_view word, std::span<const std::string_view> choices, const std::string& plural);

}  // namespace ray
