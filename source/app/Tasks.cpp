#include "source/app/Tasks.h"

#include "source/accelerate/Accelerator.h"
#include "source/app/files/ConvertScene.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/Outputs.h"
#include "source/app/manual/Completion.h"
#include "source/app/manual/Help.h"
#include "source/app/manual/Listing.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Advice.h"
#include "source/app/report/Check.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Resources.h"
#include "source/render/PixelTrace.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Everything that rendering would do short of the first ray, and a look for likely mistakes.
std::string CheckScene(const Options& asked) {
  if (!asked.files.picture.empty()) CheckOutputs(asked.files, RegionOf(asked.render));
  const ParsedScene parsed = Parse(asked.files.scene, asked.parse);
  const Options options = WithSettingsOf(parsed.scene, asked);
  const World world(parsed.scene);
  std::vector<std::string> warnings = parsed.warnings;
  for (const std::string& warning : world.Warnings()) warnings.push_back(warning);
  for (const std::string& mistake : LikelyMistakes(world, options.render)) warnings.push_back(mistake);
  TellAll(warnings);
  if (options.quiet) return {};
  std::string settings;
  for (const std::string& setting : SettingsInForce(parsed.scene, asked)) settings += "  " + setting + "\n";
  if (!settings.empty()) settings = "settings of the scene\n" + settings;
  return SceneSummary(world, options.render) + settings +
         (warnings.empty() ? "no warnings" : Counted(warnings.size(), "warning")) + "\n";
}

std::string FilesOfScene(const Options& options) {
  const ParsedScene parsed = Parse(options.files.scene, options.parse);
  TellAll(parsed.warnings);
  std::string lines;
  for (const std::string& file : parsed.scene.files) lines += file + "\n";  // as it is: for programs
  return lines;
}

std::string ConvertScene(const Options& options) {
  const OutputFile scn = CheckScnOutput(options.subject, options.files.scene);
  const ParsedScene parsed = Parse(options.files.scene, options.parse);
  RefuseInputs(scn, parsed.scene.files);
  WithSettingsOf(parsed.scene, options);  // a setting that is wrong is the original's mistake
  TellAll(parsed.warnings);
  return WriteSceneAsScn(parsed.scene, scn, options.quiet);
}

/// What `tell` says of a scene that is ready to be traced.
template <typename Tell>
std::string OfBuiltScene(const Options& asked, const Tell& tell) {
  CheckMachine(asked.render, asked.accelerator);
  const ParsedScene parsed = Parse(asked.files.scene, asked.parse);
  const Options options = WithSettingsOf(parsed.scene, asked);
  const World world(parsed.scene);
  TellAll(parsed.warnings);
  TellAll(world.Warnings());
  const auto accelerator = FindAcceleratorKind(options.accelerator.name)->Make(world, options.accelerator);
  return tell(world, *accelerator, options);
}

std::string AdviceOn(const World& world, const Accelerator& accelerator, const Options& options) {
  return Advice(world, accelerator, options, CpuSeconds());
}

std::string RaysOfPixel(const World& world, const Accelerator& accelerator, const Options& options) {
  return DebugPixel(world, accelerator, options.render, options.pixel->x, options.pixel->y,
                    options.verbose ? Digits::all : Digits::five);
}

std::string ResultOf(const Options& options, const std::vector<std::string>& keys) {
  switch (options.task) {
    case Task::render:
    case Task::view:
    case Task::command:
    case Task::grade:
    case Task::as_course:
      break;  // not ours
    case Task::check:
      return CheckScene(options);
    case Task::files:
      return FilesOfScene(options);
    case Task::advise:
      return OfBuiltScene(options, AdviceOn);
    case Task::convert:
      return ConvertScene(options);
    case Task::debug_pixel:
      return OfBuiltScene(options, RaysOfPixel);
    case Task::info:
      return PictureInfo(options.subject);
    case Task::help:
      return Help(options.program, options.subject);
    case Task::version:
      return Version(options.program);
    case Task::list:
      return Listing(options.program, options.subject, keys);
    case Task::complete:
      return CompletionScript(options.program, options.subject);
    case Task::manual:
      return ManualPage(options.subject, options.program);
  }
  return {};
}

}  // namespace

void DoTask(const Options& options, const std::vector<std::string>& keys) {
  WriteStandardOutput(ResultOf(options, keys));
}

}  // namespace ray
