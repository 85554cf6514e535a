#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_highlight_mistake{
    .name = "no_highlight",
    .title = "no highlights",
    .expected = "Phong's highlight is ks (V.R)^n IL, with R the light's direction mirrored about the normal.",
    .hint = "Look for a bright spot on the shiniest surface.",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.ks = {}; }); },
};

}  // namespace ray::grade
