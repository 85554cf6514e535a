#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake light_color_ignored_mistake{
    .name = "light_color_ignored",
    .title = "the color of lights is ignored",
    .expected = "All terms of a light are multiplied, channel by channel, by its color.",
    .hint = "Try one red light.",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            for (const char* channel : {"r", "g", "b"})
              if (double* value = light.At(channel); value && *value > 0) *value = 1;
          });
        },
};

}  // namespace ray::grade
