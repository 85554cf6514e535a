#include "source/app/Answers.h"

#include "source/app/PreparedScene.h"
#include "source/app/files/ConvertScene.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/Outputs.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"
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

/// Returns the answer of `describe` for a scene that is ready for tracing.
template <typename Describe>
std::string DescribeBuiltScene(const Options& all, const Describe& describe) {
  ReadScene read(As<RenderOptions>(all));
  PrintLines(read.parsed.warnings);
  const PreparedScene scene(read);
  PrintLines(scene.world.Warnings());
  return describe(scene.world, *scene.accelerator, read.options);
}

}  // namespace

namespace answer {

/// Does everything before the first ray of a render, and checks for likely mistakes.
std::string Check(const Options& all) {
  const auto& asked = As<RenderOptions>(all);
  if (!asked.files.image.empty()) CheckOutputs(asked.files, RegionOf(asked.render));
  const ReadScene read(asked);
  const auto& [parsed, options] = read;
  const World world(parsed.scene);
  std::vector<std::string> warnings = parsed.warnings;
  for (const std::string& warning : world.Warnings()) warnings.push_back(warning);
  for (const std::string& mistake : LikelyMistakes(world, options.render)) warnings.push_back(mistake);
  PrintLines(warnings);
  if (options.quiet) return {};
  std::string settings;
  for (const std::string& setting : SettingsInForce(parsed.scene, asked)) settings += "  " + setting + "\n";
  if (!settings.empty()) settings = "settings of the scene\n" + settings;
  return SceneSummary(world, options.render) + settings +
         (warnings.empty() ? "no warnings" : Counted(warnings.size(), "warning")) + "\n";
}

std::string Files(const Options& all) {
  const auto& options = As<RenderOptions>(all);
  const ParsedScene parsed = Parse(options.files.scene, options.parse);
  PrintLines(parsed.warnings);
  std::string lines;
  for (const std::string& file : parsed.scene.files) lines += file + "\n";  // unescaped, for programs
  return lines;
}

std::string Convert(const Options& all) {
  const auto& options = As<RenderOptions>(all);
  const OutputFile scn = CheckScnOutput(options.subject, options.files.scene);
  const ParsedScene parsed = Parse(options.files.scene, options.parse);
  RefuseInputs(scn, parsed.scene.files);
  WithSettingsOf(parsed.scene, options);  // a wrong setting is a mistake in the original
  PrintLines(parsed.warnings);
  return WriteSceneAsScn(parsed.scene, scn, options.quiet);
}

std::string Advise(const Options& all) {
  return DescribeBuiltScene(all, [](const World& world, const Accelerator& accelerator, const RenderOptions& options) {
    return Advice(world, accelerator, options, CpuSeconds());
  });
}

std::string RaysOfPixel(const Options& all) {
  return DescribeBuiltScene(all, [](const World& world, const Accelerator& accelerator, const RenderOptions& options) {
    return DebugPixel(world, accelerator, options.render, options.pixel->x, options.pixel->y,
                      options.verbose ? Digits::all : Digits::five);
  });
}

std::string Info(const Options& options) { return ImageInfo(options.subject); }
std::string Help(const Options& options) { return ray::Help(*options.program, options.subject); }
std::string Version(const Options& options) { return ray::Version(*options.program); }
std::string List(const Options& options) { return Listing(*options.program, options.subject, options.keys); }
std::string Complete(const Options& options) { return BashCompletion(*options.program); }
std::string Manual(const Options& options) { return ManualPage(options.subject, *options.program); }

}  // namespace answer

void AnswerRequest(const Options& options) { WriteStandardOutput(AnswerTo(*options.request)(options)); }

}  // namespace ray
