#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake half_turn_mistake{
    .name = "half_turn",
    .title = "the image is turned by half a turn",
    .expected = "Seen from the eye, x of the image plane grows to the right, and y upward.",
    .hint = "A pinhole's own image is upside down; the image plane in front of the eye is not.",
    .of_image =
        [](const R2::Image& image) {
          return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
            return PixelPlace{image.Width() - 1 - x, image.Height() - 1 - y};
          });
        },
};

}  // namespace ray::grade
