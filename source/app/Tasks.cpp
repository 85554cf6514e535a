#include "source/app/Tasks.h"

#include "source/accelerate/Accelerator.h"
#include "source/app/Check.h"
#include "source/app/CommandLine.h"
#include "source/app/Completion.h"
#include "source/app/Help.h"
#include "source/app/Info.h"
#include "source/app/Listing.h"
#include "source/app/Manual.h"
#include "source/app/Messages.h"
#include "source/app/OutputFile.h"
#include "source/app/Outputs.h"
#include "source/app/Words.h"
#include "source/render/PixelTrace.h"

namespace ray {
namespace {

/// Everything that rendering would do short of the first ray, and a look for likely mistakes.
std::string CheckScene(const Options& options) {
  if (!options.picture.empty()) CheckOutputs(options);
  const ParsedScene parsed = Parse(options.scene, options.parse);
  const World world(parsed.scene);
  std::vector<std::string> warnings = parsed.warnings;
  for (const std::string& warning : world.Warnings()) warnings.push_back(warning);
  for (const std::string& mistake : LikelyMistakes(world, options.render)) warnings.push_back(mistake);
  TellAll(warnings);
  if (options.quiet) return {};
  return SceneSummary(world, options.render) +
         (warnings.empty() ? "no warnings" : Counted(warnings.size(), "warning")) + "\n";
}

std::string RaysOfPixel(const Options& options) {
  CheckMachine(options);
  const ParsedScene parsed = Parse(options.scene, options.parse);
  const World world(parsed.scene);
  TellAll(parsed.warnings);
  TellAll(world.Warnings());
  const auto accelerator = FindAcceleratorKind(options.accelerator.name)->make(world, options.accelerator);
  return DebugPixel(world, *accelerator, options.render, options.pixel->x, options.pixel->y);
}

std::string ResultOf(const Options& options) {
  switch (options.task) {
    case Task::render:
    case Task::view:
      break;  // not ours
    case Task::check:
      return CheckScene(options);
    case Task::debug_pixel:
      return RaysOfPixel(options);
    case Task::info:
      return PictureInfo(options.subject);
    case Task::help:
      return Help(options.program, options.subject);
    case Task::version:
      return Version(options.program);
    case Task::list:
      return Listing(options.program, options.subject);
    case Task::complete:
      return CompletionScript(options.program, options.subject);
    case Task::manual:
      return ManualPage(options.subject, options.program);
  }
  return {};
}

}  // namespace

void DoTask(const Options& options) { WriteStandardOutput(ResultOf(options)); }

}  // namespace ray
