#pragma once

#include <array>
#include <charconv>
#include <string>

/// Numbers as people and scene files read them, whatever the locale.
namespace ray {

/// With so many digits behind the point.
std::string Fixed(double number, int digits_behind_point);

/// The shortest text that reads back as the same number.
template <class T>
std::string ToText(T number) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), end);
}

/// With at most `digits` digits that count.
std::string Rounded(double number, int digits);

/// A count or a mean of counts, below 2^63, that reads back as the same number: "1000000", "24.3125".
std::string CountText(double count);

/// A number with at most `digits` digits that count, but all those before the point, and never as a power of ten.
std::string Plain(double number, int digits);

}  // namespace ray
