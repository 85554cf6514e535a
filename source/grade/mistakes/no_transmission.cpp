#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_transmission_mistake{
    .name = "no_transmission",
    .title = "nothing is seen through transparent surfaces",
    .expected = "What is seen through a surface is added, weighted by its transmittance.",
    .hint = "Is a ray sent on through glass?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kt = {}; }); },
};

}  // namespace ray::grade
