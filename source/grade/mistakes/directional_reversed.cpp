#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake directional_reversed_mistake{
    .name = "directional_reversed",
    .title = "directional lights shine backwards",
    .expected = "A directional light's vector is where the light goes; towards the light is its opposite.",
    .hint = "Which side of a sphere is lit?",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            for (const char* axis : {"dx", "dy", "dz"})
              if (double* value = light.At(axis); value && light.kind == "dir_light") *value = -*value;
          });
        },
};

}  // namespace ray::grade
