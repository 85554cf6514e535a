// rayview shows a scene and traces what is seen. Its options are in OptionTable.cpp, beside raypro's.
#include <memory>
#include <string>
#include <vector>

#include "source/app/GuardedMain.h"
#include "source/app/Status.h"
#include "source/app/Tasks.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/app/rayview/ViewSession.h"
#include "source/app/report/Messages.h"
#include "source/view/LoadedScene.h"
#include "source/view/Viewer.h"

namespace ray {
namespace {

int ViewScene(const Options& asked) {
  CheckMachine(asked);
  const ViewOutputs outputs = CheckViewOutputs(asked);
  const auto scene = std::make_shared<const LoadedScene>(asked.scene, asked.parse, asked.accelerator);
  const Options options = WithSettingsOf(scene->parsed.scene, asked);
  RefuseInputs(outputs, scene->parsed.scene.files);
  TellAll(scene->parsed.warnings);
  TellAll(scene->world.Warnings());
  return View(asked, options, outputs, scene);
}

int Run(const std::vector<std::string>& words) {
  const Options options = ReadCommandLine(Program::rayview, words);
  if (options.task == Task::view) return ViewScene(options);
  DoTask(options, Viewer::Help());
  return status::done;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) { return ray::GuardedMain(ray::Program::rayview, argc, argv, ray::Run); }
