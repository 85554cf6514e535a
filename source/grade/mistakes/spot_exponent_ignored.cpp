#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake spot_exponent_ignored_mistake{
    .name = "spot_exponent_ignored",
    .title = "spot lights do not fade towards the rim",
    .expected = "Within the cone, light is multiplied by the cosine of the angle to the axis, to the power sd.",
    .hint = "How bright is the middle of the cone beside its rim?",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            if (double* exponent = light.At("sd")) *exponent = 0;
          });
        },
};

}  // namespace ray::grade
