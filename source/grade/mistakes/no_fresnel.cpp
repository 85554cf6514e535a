#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_fresnel_mistake{
    .name = "no_fresnel",
    .title = "glass does not reflect by its angle",
    .expected = "Fresnel's equations share light between the reflected and the refracted ray.",
    .hint = "Is a glass sphere brighter near its rim?",
    .make =
        [](Variant& v) {
          if (v.settings.trace.fresnel) v.settings.trace.internal_reflection = true;
          v.settings.trace.fresnel = false;
        },
};

}  // namespace ray::grade
