#include "source/text/NumberText.h"

#include <cmath>
#include <cstdint>

namespace ray {
namespace {

constexpr std::size_t longest = 400;  // a double in full has 309 digits before its point

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

}  // namespace ray
