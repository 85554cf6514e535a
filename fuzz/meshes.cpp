// The first byte chooses the format, and whether the mesh is read by itself or named by a scene that makes normals for
// it.
#include "fuzz/Fuzz.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size == 0) return 0;
  const char* const extensions[] = {"obj", "off", "ply", "ray", "stl"};
  const std::string extension = extensions[data[0] % 5];
  const fuzz::Bytes mesh{data + 1, size - 1};
  if (data[0] < 128) return fuzz::ReadScene(extension, "", mesh);
  fuzz::FileOf("mesh." + extension, mesh);
  return fuzz::ReadScene("scn", "", fuzz::BytesOf("mesh -1 mesh." + extension + " smooth 40 materials"));
}
