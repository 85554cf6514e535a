#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake gray_mistake{
    .name = "gray",
    .title = "the image has no colors",
    .expected = "The three channels are computed separately.",
    .hint = "Is one number returned where three are due?",
    .of_image =
        [](const R2::Image& image) {
          return EachColor(image, [](const R2::Color& c) {
            const double gray = (c.r + c.g + c.b) / 3;
            return R2::Color{gray, gray, gray};
          });
        },
};

}  // namespace ray::grade
