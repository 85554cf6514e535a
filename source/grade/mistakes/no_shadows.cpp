#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_shadows_mistake{
    .name = "no_shadows",
    .title = "no shadows",
    .expected = "A light counts only where nothing lies between the point and the light.",
    .hint = "Is a ray sent from the point to each light?",
    .make = [](Variant& v) { v.settings.trace.shadows = false; },
};

}  // namespace ray::grade
