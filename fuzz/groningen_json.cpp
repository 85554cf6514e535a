#include "fuzz/Fuzz.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  return fuzz::ReadScene("json", "groningen", {data, size});
}
