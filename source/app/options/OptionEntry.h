#pragma once

#include "source/app/options/OptionTable.h"
#include "source/text/EnumNames.h"

/// The location of an option's value in a program's own options: one lambda that reads const Options and writes mutable
/// ones.
#define AT_OF(Own, member) \
  [](auto& o) -> auto& { return As<Own>(o).member; }

namespace ray {

/// Makes the entry of a word from a closed set, stored as an enumerator.
template <class Enum, class Lambda>
OneNameOf OneOfEnum(Lambda, bool by_number = false) {
  return {[] { return std::vector<std::string>(NamesOf(Enum{}).begin(), NamesOf(Enum{}).end()); },
          [](const Options& options) { return std::string(NameOf(Lambda{}(options))); },
          [](Options& options, const std::string& name) { Lambda{}(options) = *Named<Enum>(name); }, by_number};
}

/// Makes the entry of a word from an open set, stored unchanged.
template <class Lambda>
OneNameOf OneOfNames(Lambda, std::vector<std::string> (*choices)()) {
  return {choices, [](const Options& options) { return Lambda{}(options); },
          [](Options& options, const std::string& name) { Lambda{}(options) = name; }};
}

/// Makes the entry of several numbers stored as one value: `read` returns std::nullopt if they are out of range, `show`
/// formats the current ones.
template <auto read, auto show, class Lambda>
NumberList NumbersOf(Lambda, const char* range) {
  return {[](const Options& options) -> std::vector<double> { return show(Lambda{}(options)); },
          [](Options& options, std::span<const double> numbers) {
            const auto value = read(numbers);
            if (value) Lambda{}(options) = *value;
            return value.has_value();
          },
          range};
}

/// Makes the entry of a word that `read` parses, returning std::nullopt if it is invalid, and `show` formats.
template <auto read, auto show, class Lambda>
Word WordOf(Lambda, const char* range, std::vector<std::string> (*names)() = nullptr, bool is_list = false) {
  return {[](Options& options, const std::string& word) {
            const auto value = read(word);
            if (value) Lambda{}(options) = *value;
            return value.has_value();
          },
          [](const Options& options) { return std::string(show(Lambda{}(options))); }, range, names, is_list};
}

}  // namespace ray
