#include <numbers>

#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake spot_cutoff_ignored_mistake{
    .name = "spot_cutoff_ignored",
    .title = "spot lights have no cone",
    .expected = "Beyond its cut-off angle a spot light gives nothing.",
    .hint = "Look for the rim of the cone on the floor.",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            if (double* cutoff = light.At("sc")) *cutoff = std::numbers::pi;
          });
        },
};

}  // namespace ray::grade
