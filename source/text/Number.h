#pragma once

#include <cstdint>
#include <string_view>

namespace ray {

/// A number read from a word, or the problem with the word, phrased to follow a name: "must be a number".
template <class T>
struct ReadNumber {
  T value{};
  const char* problem = nullptr;
};

/// Parses a decimal number that is the whole word: .5, 5., +20, -1e-3. Rejects NaN, infinities, hexadecimal and numbers
/// that overflow, for overflow with an infinite value; tiny numbers become 0 or denormal. Independent of the locale.
ReadNumber<double> ParseNumber(std::string_view word);

/// Returns true if a word is one that programs print for a number that is not finite: "nan", "-inf", "-nan(ind)",
/// "NaNQ", and with older Windows libraries "1.#QNAN", "-1.#IND00" or, rounded to few digits as if it were a number,
/// "1.#J".
bool SaysNanOrInfinity(std::string_view word);

/// Parses a decimal integer that is the whole word; a leading + is allowed.
ReadNumber<std::int64_t> ParseWhole(std::string_view word);

}  // namespace ray
