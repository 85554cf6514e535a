#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_reflection_mistake{
    .name = "no_reflection",
    .title = "no reflections",
    .expected = "What a mirror ray sees is added, weighted by the mirror's reflectance.",
    .hint = "Is a ray sent on from mirrors?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kr = {}; }); },
};

}  // namespace ray::grade
