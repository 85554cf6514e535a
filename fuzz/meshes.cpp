// The first byte chooses the format.
#include "fuzz/Fuzz.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size == 0) return 0;
  const char* const extensions[] = {"obj", "off", "ply", "ray", "stl"};
  return fuzz::ReadScene(extensions[data[0] % 5], "", {data + 1, size - 1});
}
