#include "source/text/NumberText.h"

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

}  // namespace ray
