#include <algorithm>

#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake tone_mapped_mistake{
    .name = "tone_mapped",
    .title = "the image is tone mapped",
    .expected = "Values are clamped to [0, 1] and nothing else.",
    .hint = "What is written for a value of 1?",
    .of_image =
        [](const R2::Image& image) {
          return EachChannel(image, [](double channel) { return channel / (1 + std::max(0.0, channel)); });
        },
};

}  // namespace ray::grade
