#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake upside_down_mistake{
    .name = "upside_down",
    .title = "the image is upside down",
    .expected = "Row 0 is at the top in image files; the image plane's y points up.",
    .hint = "Which way does y grow in your image?",
    .of_image =
        [](const R2::Image& image) {
          return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
            return PixelPlace{x, image.Height() - 1 - y};
          });
        },
};

}  // namespace ray::grade
