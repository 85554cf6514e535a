#include "source/text/NumberText.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace ray {
namespace {

constexpr std::size_t longest = 400;  // a double in full has up to 309 digits before its point

}  // namespace

std::string Fixed(double number, int digits_behind_point) {
  std::array<char, longest> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, digits_behind_point);
  return std::string(text.data(), end);
}

std::string Rounded(double number, int digits) {
  std::array<char, longest> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
  return std::string(text.data(), end);
}

std::string CountText(double count) {
  return count == std::floor(count) ? ToText(static_cast<std::int64_t>(count)) : ToText(count);
}

std::string Plain(double number, int digits) {
  const std::string rounded = Rounded(number, digits);
  const std::size_t e = rounded.find('e');
  if (e == std::string::npos) return rounded;
  const int exponent = std::atoi(rounded.c_str() + e + 1);
  std::string text = Fixed(number, std::max(0, digits - 1 - exponent));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace ray
