#include "source/grade/Mistake.h"

#include <array>

#include "source/grade/Changes.h"

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

Scene& Variant::OwnScene() {
  if (!own_) own_ = Copied(original_);
  return *own_;
}

}  // namespace ray::grade
