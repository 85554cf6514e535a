#pragma once

#include <cstdint>
#include <string_view>

namespace ray {

/// A number read from a word, or what is wrong with the word, phrased to follow a name: "must be a number".
template <class T>
struct ReadNumber {
  T value{};
  const char* problem = nullptr;
};

/// A decimal number, the whole word: .5, 5., +20, -1e-3. NaN, infinities, hexadecimal and what overflows are refused,
/// the last with an infinite value; what is too small becomes 0 or a denormal number. Never asks the locale.
ReadNumber<double> ParseNumber(std::string_view word);

/// Whether a word is one that programs print for a number that is not finite: "nan", "-inf", "-nan(ind)", "NaNQ", and
/// with older Windows libraries "1.#QNAN", "-1.#IND00" or, rounded to few digits as if it were a number, "1.#J".
bool SaysNanOrInfinity(std::string_view word);

/// A decimal integer, the whole word, a leading + allowed.
ReadNumber<std::int64_t> ParseWhole(std::string_view word);

}  // namespace ray
