#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake half_vector_mistake{
    .name = "half_vector",
    .title = "the half vector in place of the mirrored light",
    .expected =
        "This course's highlight is (V.R)^n: R is the light's direction mirrored about N, V points to the viewer.",
    .hint = "(N.H)^n is Blinn's highlight, which is wider than Phong's.",
    .make = [](Variant& v) { v.rules.half_vector = true; },
};

}  // namespace ray::grade
