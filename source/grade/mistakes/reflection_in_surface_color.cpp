#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake reflection_in_surface_color_mistake{
    .name = "reflection_in_surface_color",
    .title = "reflections tinted by the diffuse color",
    .expected = "What the mirror ray sees is multiplied by the mirror's reflectance only.",
    .hint = "Which color multiplies the reflection?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kr = m.kr * m.kd; }); },
};

}  // namespace ray::grade
