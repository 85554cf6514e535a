// Every format, known by its content; what can be read is laid around a scene too.
#include "R2/ImageFile.h"
#include "fuzz/Fuzz.h"
#include "source/scene/Environment.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::int64_t most_pixels = 1 << 16;  // larger ones are slow and tell nothing more
  try {
    const R2::ImageHeader header = R2::ReadImageHeader({data, size});
    if (std::int64_t{header.size.width} * header.size.height > most_pixels) return 0;
    ray::Environment(R2::DecodeImage({data, size}).image);
  } catch (const R2::ImageError&) {
  } catch (const std::invalid_argument&) {  // of the environment
  }
  return 0;
}
