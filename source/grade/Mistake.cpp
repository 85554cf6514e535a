#include "source/grade/Mistake.h"

#include <algorithm>
#include <array>

namespace ray::grade {

#define MISTAKE(name) extern const Mistake name##_mistake;
#include "source/grade/mistakes.def"
#undef MISTAKE

std::span<const Mistake* const> Mistakes() {
  static const std::array mistakes{
#define MISTAKE(name) &name##_mistake,
#include "source/grade/mistakes.def"
#undef MISTAKE
  };
  return mistakes;
}

const Mistake* FindMistake(const std::string& name) {
  const auto found = std::ranges::find_if(Mistakes(), [&](const Mistake* mistake) { return name == mistake->name; });
  return found == Mistakes().end() ? nullptr : *found;
}

}  // namespace ray::grade
