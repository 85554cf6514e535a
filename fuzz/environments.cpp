// Pixels of any numbers, laid around a scene: what is drawn must be what is seen there. The first two bytes choose
// width and height, the next two where to draw.
#include <cmath>
#include <cstring>

#include "fuzz/Fuzz.h"
#include "source/scene/Environment.h"

namespace {

/// Takes four bytes; 0 once they are used up. Without a sign, since nothing is learned from refusing most pictures.
double Channel(fuzz::Bytes& bytes) {
  float number = 0;
  if (bytes.size() < sizeof number) return 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes = bytes.subspan(sizeof number);
  return std::fabs(number);
}

R2::Image ImageOf(int width, int height, fuzz::Bytes bytes) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double red = Channel(bytes), green = Channel(bytes), blue = Channel(bytes);
      image.Set(x, y, {red, green, blue});
    }
  return image;
}

}  // namespace

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size < 4) return 0;
  constexpr int most = 16;  // enough for every layout; larger ones tell nothing more
  try {
    const ray::Environment environment(ImageOf(1 + data[0] % most, 1 + data[1] % most, {data + 4, size - 4}));
    const ray::Environment::Sample drawn = environment.Draw({data[2] / 255.0, data[3] / 255.0});
    const ray::Environment::Seen seen = environment.SeenTowards(drawn.direction);
    if (!(drawn.pdf > 0 && std::isfinite(drawn.pdf))) std::abort();
    if (!(seen.pdf == drawn.pdf && seen.radiance == drawn.radiance)) std::abort();
  } catch (const std::invalid_argument&) {  // of another shape, or not finite
  }
  return 0;
}
