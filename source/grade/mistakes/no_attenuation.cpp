#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake no_attenuation_mistake{
    .name = "no_attenuation",
    .title = "light does not fade with distance",
    .expected = "Light from a place arrives divided by ca + la d + qa d^2, d the distance.",
    .hint = "Move a point light away: the scene should darken.",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            if (light.kind == "dir_light") return;
            if (double* ca = light.At("ca")) *ca = 1, *light.At("la") = 0, *light.At("qa") = 0;
          });
        },
};

}  // namespace ray::grade
