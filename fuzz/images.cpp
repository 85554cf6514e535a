// Every format, known by its content.
#include "R2/ImageFile.h"
#include "fuzz/Fuzz.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::int64_t most_pixels = 1 << 14;  // larger ones are slow and tell nothing more
  try {
    const R2::ImageHeader header = R2::ReadImageHeader({data, size});
    if (std::int64_t{header.size.width} * header.size.height > most_pixels) return 0;
    R2::DecodeImage({data, size});
  } catch (const R2::ImageError&) {
  }
  return 0;
}
