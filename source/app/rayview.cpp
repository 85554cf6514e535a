// rayview shows a scene and traces the view. Its options are in RenderTable.cpp, next to raypro's.
#include <algorithm>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "source/app/Answers.h"
#include "source/app/GuardedMain.h"
#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/RenderChecks.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/rayview/LoadingWindow.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/app/rayview/ViewSession.h"
#include "source/app/report/Messages.h"
#include "source/draw/contexts/Context.h"
#include "source/inspect/LoadedScene.h"
#include "source/view/KeyBindings.h"

namespace ray {
namespace {

/// Returns true if a window stays open for a user.
bool StaysOpen(const ViewOptions& view) { return IsLookedAt(view) && !view.exit_immediately; }

/// Returns the scene. If it has mistakes and the user can see them in a window while editing the files, returns the
/// mistakes and a scene with the files to watch.
std::shared_ptr<const LoadedScene> SceneFor(const ViewerOptions& asked, std::optional<SceneErrors>& mistakes) {
  if (asked.files.scene.empty()) return std::make_shared<const LoadedScene>(ParsedScene{}, asked.accelerator);
  try {
    return std::make_shared<const LoadedScene>(asked.files.scene, asked.parse, asked.accelerator);
  } catch (const SceneErrors& errors) {
    std::error_code ignored;
    if (!StaysOpen(asked.view) || !std::filesystem::is_regular_file(asked.files.scene, ignored)) throw;
    mistakes = errors;
    ParsedScene nothing;
    nothing.scene.files = {asked.files.scene};
    for (const SceneError& error : errors.All())
      if (std::ranges::find(nothing.scene.files, error.file) == nothing.scene.files.end())
        nothing.scene.files.push_back(error.file);
    return std::make_shared<const LoadedScene>(std::move(nothing), asked.accelerator);
  }
}

int ViewScene(const ViewerOptions& asked) {
  CheckMachine(asked.render, asked.accelerator);
  const ViewOutputs outputs = CheckViewOutputs(asked.files, asked.view, asked.render.width, asked.render.height);
  std::optional<SceneErrors> mistakes;
  auto loading = std::async(std::launch::async, [&] { return SceneFor(asked, mistakes); });
  std::unique_ptr<Window> window;
  if (StaysOpen(asked.view) && HasWindows())
    window = WindowUntilLoaded(loading, asked.render.width, asked.render.height, asked.files.scene);
  const auto scene = loading.get();
  const ViewerOptions options = WithSettingsOf(scene->parsed.scene, asked);
  RefuseInputs(outputs, scene->parsed.scene.files);
  PrintLines(scene->parsed.warnings);
  PrintLines(scene->world.Warnings());
  try {
    return View(asked, options, outputs, scene, mistakes ? &*mistakes : nullptr, std::move(window));
  } catch (const ContextError&) {
    if (mistakes) throw *mistakes;  // there is no window to show them in
    throw;
  }
}

int Run(const std::vector<std::string>& words) {
  if (words.empty() && HasWindows()) try {
      return ViewScene({});          // a start page
    } catch (const ContextError&) {  // without a display, what is missing is the scene
    }
  ViewerOptions options = ReadCommandLine<ViewerOptions>(Program::rayview, words);
  if (!options.request) return ViewScene(options);
  options.keys = LinesOfHelp();
  AnswerRequest(options);
  return status::done;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) { return ray::GuardedMain(ray::Program::rayview, argc, argv, ray::Run); }
