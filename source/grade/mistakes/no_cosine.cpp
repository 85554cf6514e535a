#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_cosine_mistake{
    .name = "no_cosine",
    .title = "no cosine: surfaces are as bright at any angle to the light",
    .expected = "Diffuse reflection falls with the cosine N.L of the angle to the light.",
    .hint = "How bright is a sphere near the line where light and shade meet?",
    .make = [](Variant& v) { v.rules.cosine = ShadingRules::Cosine::none; },
};

}  // namespace ray::grade
