#pragma once

#include <array>
#include <charconv>
#include <string>

/// Numbers formatted for people and scene files, independent of the locale.
namespace ray {

/// Formats the number with `digits_behind_point` digits after the point.
std::string Fixed(double number, int digits_behind_point);

/// Returns the shortest text that reads back as the same number.
template <class T>
std::string ToText(T number) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), end);
}

/// Formats the number with at most `digits` significant digits.
std::string Rounded(double number, int digits);

/// Formats a count or a mean of counts, below 2^63, so that it reads back as the same number: "1000000", "24.3125".
std::string CountText(double count);

/// Formats a number with at most `digits` significant digits, but all digits before the point, and never with an
/// exponent.
std::string Plain(double number, int digits);

}  // namespace ray
