#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake ambient_per_light_mistake{
    .name = "ambient_per_light",
    .title = "ambient light added once per light",
    .expected = "ka Ia is added once per point, outside of the sum over the lights.",
    .hint = "Count how often the ambient term is added where two lights shine.",
    .make = [](Variant& v) { v.scene.ambient = static_cast<double>(v.scene.lights.size()) * v.scene.ambient; },
};

}  // namespace ray::grade
