#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake exponent_ignored_mistake{
    .name = "exponent_ignored",
    .title = "the shininess exponent is ignored",
    .expected = "The highlight is (V.R) to the power of the material's exponent n.",
    .hint = "How large is the highlight as n grows?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.n = 1; }); },
};

}  // namespace ray::grade
