#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_diffuse_mistake{
    .name = "no_diffuse",
    .title = "no diffuse term",
    .expected = "Diffuse reflection is kd (N.L) IL, for each light that a point sees.",
    .hint = "Away from highlights, does turning a light off change anything?",
    .make = [](Variant& v) { ChangeMaterials(v.OwnScene(), [](Material& m) { m.kd = {}; }); },
};

}  // namespace ray::grade
