#include "source/parse/Variables.h"

#include <algorithm>
#include <stdexcept>

#include "R3/Expression.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"

namespace ray {

bool Variables::IsName(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

bool IsDefinition(const std::string& text) {
  const std::size_t equals = text.find('=');
  return equals != std::string::npos && equals + 1 < text.size() &&
         Variables::IsName(std::string_view(text).substr(0, equals));
}

Variables::Variables(std::span<const std::string> definitions) {
  for (const std::string& text : definitions) {
    const std::size_t equals = text.find('=');
    values_[text.substr(0, equals)] = text.substr(equals + 1);
    unused_.insert(text.substr(0, equals));
  }
}

void Variables::Define(std::string_view name, std::string_view value) { values_.try_emplace(std::string(name), value); }

const std::string* Variables::Find(std::string_view name) {
  const auto found = values_.find(name);
  if (found == values_.end()) return nullptr;
  unused_.erase(found->first);
  return &found->second;
}

const std::string& Variables::Evaluate(std::string_view formula) {
  const double value = R3::Evaluate(formula, [&](std::string_view name) {
    const std::string* text = Find(name);
    if (name.empty()) throw std::runtime_error("the name of a variable is missing");
    if (!text) {
      const std::string word(name);
      throw std::runtime_error("'$" + word + "' is not defined; use 'define " + word + " 0.5', or -define " + word +
                               "=0.5");
    }
    const auto [number, problem] = ParseNumber(*text);
    if (problem)
      throw std::runtime_error("'$" + std::string(name) + "' stands for " + Quoted(*text) + ", which is not a number");
    return number;
  });
  return evaluated_.emplace_back(ToText(value));
}

}  // namespace ray
