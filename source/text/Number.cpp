#include "source/text/Number.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "source/text/LowerCase.h"

namespace ray {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Removes a plus sign, which from_chars does not accept; no second sign may follow.
std::string_view WithoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

std::string_view WithoutSign(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return word;
}

/// Returns true if `name` is what printf of Microsoft's libraries up to 2013 prints after "1.#" for NaN and infinity: a
/// name, padded with zeros and an exponent. With fewer digits than letters, it rounds the last letter up: "1.#INF" to
/// two digits is "1.#J". The whole word must match, since a # after a number may also start a comment.
bool IsWindowsName(std::string_view name) {
  constexpr std::string_view whole[] = {"inf", "ind", "qnan", "snan", "nan"};
  constexpr std::string_view rounded[] = {"J", "IO", "R", "QO", "QNB", "T", "SO", "SNB"};
  if (std::ranges::find(rounded, name) != std::end(rounded)) return true;
  for (const std::string_view letters : whole) {
    if (!BeginsInAnyCase(name, letters)) continue;
    name.remove_prefix(letters.size());
    name.remove_prefix(std::min(name.find_first_not_of('0'), name.size()));
    if (name.empty()) return true;
    if ((name[0] | 0x20) != 'e') return false;
    name = WithoutSign(name.substr(1));
    return !name.empty() && std::ranges::all_of(name, IsDigit);
  }
  return false;
}

bool SaysHexadecimal(std::string_view word) {
  word = WithoutSign(word);
  return word.size() > 2 && word[0] == '0' && (word[1] | 0x20) == 'x';
}

const char* WhyNoNumber(std::string_view word) {
  if (SaysNanOrInfinity(word)) return "must be a finite number";
  if (SaysHexadecimal(word)) return "must be a decimal number";
  if (word.find(',') != std::string_view::npos) return "must be a number, with a point and no comma";
  return "must be a number";
}

/// Returns true if a well-formed decimal number outside the range of double is tiny, that is, below 1. It may have
/// thousands of zeros and digits, so the exponent alone does not decide.
bool IsBelowOne(std::string_view number) {
  if (number[0] == '-') number.remove_prefix(1);
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
  const auto first = static_cast<std::int64_t>(std::min(mantissa.find_first_not_of("0."), mantissa.size()));
  // Digits before the point, counted from the first nonzero one; negative: zeros after the point.
  const std::int64_t magnitude = first < point ? point - first : point - first + 1;
  std::int64_t exponent = 0;
  if (e < number.size()) {
    const std::string_view digits = WithoutPlus(number.substr(e + 1));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error == std::errc::result_out_of_range) return digits[0] == '-';
  }
  return exponent <= -magnitude;
}

}  // namespace

ReadNumber<double> ParseNumber(std::string_view word) {
  const std::string_view number = WithoutPlus(word);
  const char* const end = number.data() + number.size();
  const std::size_t digit = number.starts_with('-') ? 1 : 0;
  if (digit >= number.size() || !(IsDigit(number[digit]) || number[digit] == '.')) return {0, WhyNoNumber(word)};
  double value = 0;
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {0, WhyNoNumber(word)};
  if (error == std::errc::result_out_of_range) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!IsBelowOne(number)) return {infinity, "must fit a double, whose largest is 1.8e308"};
    return {0, nullptr};
  }
  return {value, nullptr};
}

bool SaysNanOrInfinity(std::string_view word) {
  const std::string_view rest = WithoutSign(word);
  if (rest.starts_with("1.#")) return IsWindowsName(rest.substr(3));
  if (IsInAnyCase(rest, "inf") || IsInAnyCase(rest, "infinity")) return true;
  if (!BeginsInAnyCase(rest, "nan")) return false;
  const std::string_view kind = rest.substr(3);  // "nan(0x7ff)" of C; "NaNQ" of AIX
  return kind.empty() || kind == "Q" || kind == "S" || (kind[0] == '(' && kind.ends_with(')'));
}

ReadNumber<std::int64_t> ParseWhole(std::string_view word) {
  const std::string_view number = WithoutPlus(word);
  const char* const end = number.data() + number.size();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {0, "must be a whole number"};
  if (error == std::errc::result_out_of_range) return {0, "must be a whole number of at most 18 digits"};
  return {value, nullptr};
}

}  // namespace ray
