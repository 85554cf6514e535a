#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake highlight_in_surface_color_mistake{
    .name = "highlight_in_surface_color",
    .title = "highlights tinted by the diffuse color",
    .expected = "The highlight is ks (V.R)^n IL; kd has no part in it.",
    .hint = "Compare the color of the highlight with that of the light.",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ks = m.ks * m.kd; }); },
};

}  // namespace ray::grade
