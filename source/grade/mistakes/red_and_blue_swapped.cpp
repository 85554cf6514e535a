#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake red_and_blue_swapped_mistake{
    .name = "red_and_blue_swapped",
    .title = "red and blue are swapped",
    .expected = "Image files hold red, green, blue; some libraries want blue first.",
    .hint = "Render a red sphere.",
    .of_image =
        [](const R2::Image& image) {
          return EachColor(image, [](const R2::Color& c) { return R2::Color{c.b, c.g, c.r}; });
        },
};

}  // namespace ray::grade
