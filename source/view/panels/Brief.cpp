#include "source/view/panels/Brief.h"

#include <algorithm>
#include <string_view>

#include "source/text/Number.h"
#include "source/view/Plain.h"

namespace ray {

std::string Brief(double number) {
  constexpr int digits = 4;  // an eye compares them
  return Plain(number, digits);
}
std::string Brief(const R2::Color& c) { return Brief(c.r) + " " + Brief(c.g) + " " + Brief(c.b); }
std::string Brief(const R3::Point& p) { return Brief(p.x) + " " + Brief(p.y) + " " + Brief(p.z); }
std::string Brief(const R3::Vector& v) { return Brief(v.x) + " " + Brief(v.y) + " " + Brief(v.z); }

std::string Brief(const std::string& words) {
  std::string text;
  for (std::size_t start = 0; start < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" ,", start), words.size() - 1) + 1;
    const std::size_t length = end - start - (words[end - 1] == ' ' || words[end - 1] == ',');
    const auto number = ParseNumber(std::string_view(words).substr(start, length));
    text += number.problem ? words.substr(start, length) : Brief(number.value);
    text += words.substr(start + length, end - start - length);
    start = end;
  }
  return text;
}

}  // namespace ray
