#include "fuzz/Fuzz.h"
#include "source/app/Status.h"
#include "source/app/report/ReadReplay.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  ray::RunStats run;
  run.options = ray::RenderOptions();
  run.scene.hash = "0123456789abcdef";
  run.options.files.replay = fuzz::FileOf("report.json", {data, size});
  try {
    ray::ReadReplay(run);
  } catch (const ray::SceneErrors&) {
  } catch (const ray::UsageError&) {
  }
  return 0;
}
