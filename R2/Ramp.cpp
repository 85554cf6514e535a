#include "R2/Ramp.h"

#include <algorithm>

#include "R1/Elementary.h"

namespace R2 {

Color RampColor(double number) {
  constexpr double start = 0.5, rotations = -1.5, hue = 1;
  const double t = number > 0 ? std::min(number, 1.0) : 0;
  const double amplitude = hue * t * (1 - t) / 2;
  const R1::SineCosine around = R1::SinCosTurns(start / 3 + 1 + rotations * t);
  const auto channel = [&](double of_cos, double of_sin) {
    return std::clamp(t + amplitude * (of_cos * around.cosine + of_sin * around.sine), 0.0, 1.0);
  };
  return {channel(-0.14861, 1.78277), channel(-0.29227, -0.90649), channel(1.97294, 0)};
}

Image RampImage(const Plane& numbers) {
  Image image(numbers.width, numbers.height);
  for (int y = 0; y < numbers.height; ++y)
    for (int x = 0; x < numbers.width; ++x) image.Set(x, y, RampColor(numbers.Row(y)[x]));
  return image;
}

}  // namespace R2
