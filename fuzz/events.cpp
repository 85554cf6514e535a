#include "fuzz/Fuzz.h"
#include "source/view/EventScript.h"

int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    for (const ray::ScriptStep& step : ray::ReadEventScript({"script", text}))
      if (const auto* event = std::get_if<ray::Event>(&step)) ray::ScriptLine(*event);
  } catch (const ray::SceneErrors&) {
  }
  return 0;
}
