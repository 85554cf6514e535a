#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake ambient_per_light_mistake{
    .name = "ambient_per_light",
    .title = "ambient light added once per light",
    .expected = "ka Ia is added once per point, outside of the sum over the lights.",
    .hint = "Count how often the ambient term is added where two lights shine.",
    .make =
        [](Variant& v) {
          Scene& scene = v.OwnScene();
          scene.ambient = static_cast<double>(scene.lights.size()) * scene.ambient;
        },
};

}  // namespace ray::grade
