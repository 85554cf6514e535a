#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake inverse_square_always_mistake{
    .name = "inverse_square_always",
    .title = "light always fades with the square of the distance",
    .expected = "Light fades as the scene file says: divided by ca + la d + qa d^2.",
    .hint = "Which of the three coefficients does your program read?",
    .make =
        [](Variant& v) {
          ChangeLights(v.OwnScene(), [](LightArguments& light) {
            if (double* ca = light.At("ca")) *ca = 0, *light.At("la") = 0, *light.At("qa") = 1;
          });
        },
};

}  // namespace ray::grade
