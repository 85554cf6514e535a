#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake transposed_mistake{
    .name = "transposed",
    .title = "rows and columns are swapped",
    .expected = "A pixel is at row times width plus column.",
    .hint = "Which of two loops is the outer one?",
    .of_image =
        [](const R2::Image& image) {
          return Moved(image, image.Width(), image.Height(), [&](int x, int y) {
            return PixelPlace{(image.Height() - 1 - y) * image.Width() / image.Height(),
                              image.Height() - 1 - x * image.Height() / image.Width()};
          });
        },
};

}  // namespace ray::grade
