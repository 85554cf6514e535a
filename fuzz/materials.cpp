// A material library that a mesh names, with images to name.
#include "fuzz/Fuzz.h"

namespace {

const std::string gray = "P3 1 2 255 9 9 9 99 99 99\n", colored = "P3 1 1 255 9 99 200\n";
const std::string mesh =
    "mtllib library.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 0 1\n"
    "usemtl a\nf 1/1 2/2 3/3\nusemtl b c\nf 1/1 3/3 2/2\nusemtl d\nf 2/2 3/3 1/1\n";

}  // namespace

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::FileOf("library.mtl", {data, size});
  fuzz::FileOf("g.ppm", fuzz::BytesOf(gray));
  fuzz::FileOf("c.ppm", fuzz::BytesOf(colored));
  return fuzz::ReadScene("obj", "", fuzz::BytesOf(mesh));
}
