#include "fuzz/Fuzz.h"
#include "source/app/Status.h"
#include "source/app/report/ReadReplay.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  ray::Options options = ray::Defaults(ray::Program::raypro);
  options.replay = fuzz::FileOf("report.json", {data, size});
  try {
    ray::ReadReplay(options, "0123456789abcdef");
  } catch (const ray::SceneErrors&) {
  } catch (const ray::UsageError&) {
  }
  return 0;
}
