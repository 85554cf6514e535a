#include "source/view/Plain.h"

#include <algorithm>
#include <cstdlib>

#include "source/text/NumberText.h"

namespace ray {

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
