#include "grader/raygrade/LoadScene.h"

#include "source/app/PreparedScene.h"
#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/text/Words.h"

namespace ray::raygrade {
namespace {

/// Returns the options of raypro; size and bytes are the suite's.
RenderOptions OptionsFor(const grade::SuiteScene& scene, const std::string& file) {
  std::vector<std::string> words{file, "reference.pfm"};
  for (const std::string& word : SplitWords(scene.options)) words.push_back(word);
  for (const auto& [option, value] : {std::pair{"-width", scene.width}, {"-height", scene.height}}) {
    words.emplace_back(option);
    words.push_back(std::to_string(value));
  }
  return ReadCommandLine(Program::raypro, words);
}

}  // namespace

grade::SceneToRender LoadScene(const grade::SuiteScene& scene, const std::string& file) {
  try {
    ReadScene read(OptionsFor(scene, file));
    return {std::move(read.parsed.scene), read.options.render, read.options.accelerator};
  } catch (const UsageError& error) {
    SceneError at = scene.options_at;
    at.message = error.what();
    if (at.file.empty()) at.file = scene.file;
    throw SceneErrors({at});
  }
}

}  // namespace ray::raygrade
