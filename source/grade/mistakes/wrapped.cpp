#include <algorithm>
#include <cmath>

#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake wrapped_mistake{
    .name = "wrapped",
    .title = "bright values wrap around",
    .expected = "Values above 1 become 255; a byte that is given more starts again at 0.",
    .hint = "Look at the brightest spots: do they have dark holes?",
    .of_image =
        [](const R2::Image& image) {
          return EachChannel(
              image, [](double channel) { return std::fmod(std::floor(255 * std::max(0.0, channel)), 256.0) / 255; });
        },
};

}  // namespace ray::grade
