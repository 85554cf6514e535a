#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake spot_whole_angle_mistake{
    .name = "spot_whole_angle",
    .title = "the cut-off angle of spot lights is taken for the whole cone",
    .expected = "The cut-off is the angle between axis and rim: half of the cone.",
    .hint = "Is the lit disc half as wide as expected?",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            if (double* cutoff = light.At("sc")) *cutoff /= 2;
          });
        },
};

}  // namespace ray::grade
