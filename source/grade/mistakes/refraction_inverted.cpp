#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake refraction_inverted_mistake{
    .name = "refraction_inverted",
    .title = "the index of refraction is inverted",
    .expected = "On entering, sin a2 = sin a1 / n; on leaving, sin a2 = n sin a1.",
    .hint = "Do rays bend towards the normal as they enter?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ir = 1 / m.ir; }); },
};

}  // namespace ray::grade
