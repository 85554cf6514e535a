// Every format, known by its content. What a header says of the size must hold for the picture.
#include <cstdlib>

#include "R2/ImageFile.h"
#include "fuzz/Fuzz.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::int64_t most_pixels = 1 << 14;  // larger ones are slow and tell nothing more
  try {
    const R2::ImageHeader header = R2::ReadImageHeader({data, size});
    if (std::int64_t{header.size.width} * header.size.height > most_pixels) return 0;
    const R2::Image image = R2::DecodeImage({data, size}).image;
    if (image.Width() != header.size.width || image.Height() != header.size.height) std::abort();
  } catch (const R2::ImageError&) {
  }
  return 0;
}
