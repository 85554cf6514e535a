#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake mirrored_mistake{
    .name = "mirrored",
    .title = "the image is mirrored left to right",
    .expected = "Right is the cross product of the view direction and up, in this order; x grows along it.",
    .hint = "In which order is the cross product taken?",
    .of_image =
        [](const R2::Image& image) {
          return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
            return PixelPlace{image.Width() - 1 - x, y};
          });
        },
};

}  // namespace ray::grade
