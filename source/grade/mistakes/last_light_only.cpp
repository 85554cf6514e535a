#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake last_light_only_mistake{
    .name = "last_light_only",
    .title = "only the last light counts",
    .expected = "The terms of all lights are added up.",
    .hint = "Is the sum kept from one light to the next?",
    .make = [](Variant& v) { v.rules.lights = ShadingRules::Lights::last; },
};

}  // namespace ray::grade
