#include <algorithm>

#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake gamma_mistake{
    .name = "gamma",
    .title = "the image is gamma encoded",
    .expected = "This course's bytes are linear: 255 times the value.",
    .hint = "Is a value of 0.5 written as 128?",
    .of_image =
        [](const R2::Image& image) {
          return EachChannel(image, [](double channel) { return R2::EncodeSrgb(std::clamp(channel, 0.0, 1.0)); });
        },
};

}  // namespace ray::grade
