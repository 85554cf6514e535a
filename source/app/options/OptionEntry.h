#pragma once

#include "source/app/options/OptionTable.h"
#include "source/text/EnumNames.h"

/// Where an option keeps its value in a program's own options: one lambda that reads const Options and writes others.
#define AT_OF(Own, member) \
  [](auto& o) -> auto& { return As<Own>(o).member; }

namespace ray {

/// A word of a closed set, kept as the enumerator it names.
template <class Enum, class Lambda>
OneNameOf OneOfEnum(Lambda, bool by_number = false) {
  return {[] { return std::vector<std::string>(NamesOf(Enum{}).begin(), NamesOf(Enum{}).end()); },
          [](const Options& options) { return std::string(NameOf(Lambda{}(options))); },
          [](Options& options, const std::string& name) { Lambda{}(options) = *Named<Enum>(name); }, by_number};
}

/// A word of an open set, kept as it is.
template <class Lambda>
OneNameOf OneOfNames(Lambda, std::vector<std::string> (*choices)()) {
  return {choices, [](const Options& options) { return Lambda{}(options); },
          [](Options& options, const std::string& name) { Lambda{}(options) = name; }};
}

/// Several numbers kept as one value: `read` has nothing for those out of range, `show` writes those in force.
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

/// A word that `read` understands, or has nothing for, and `show` writes.
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
