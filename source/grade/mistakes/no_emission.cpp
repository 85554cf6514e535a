#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_emission_mistake{
    .name = "no_emission",
    .title = "emission is ignored",
    .expected = "A surface adds its own emission to what it reflects.",
    .hint = "Look at a surface that shines though no light reaches it.",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.emission = {}; }); },
};

}  // namespace ray::grade
