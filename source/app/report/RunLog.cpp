#include "source/app/report/RunLog.h"

#include <signal.h>

#include <algorithm>
#include <thread>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/Messages.h"
#include "source/render/SceneFeatures.h"
#include "source/text/Words.h"

namespace ray {
namespace {

int ThreadsOf(const RenderSettings& settings) {
  if (settings.threads > 0) return settings.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// Options that this picture, or this accelerator, makes no use of.
std::vector<std::string> OptionsWithoutEffect(const Options& options) {
  const Options defaults;
  const R2::ImageFormat* format = R2::FormatForName(options.picture);
  const std::string kind = format ? format->name : "";
  const AcceleratorSettings& accelerator = options.accelerator;
  const bool are_devices_default = accelerator.node_boxes && accelerator.front_to_back && accelerator.last_hit;
  std::vector<std::string> names;
  if (options.encoding.bits != defaults.encoding.bits && kind != "png") names.emplace_back("-bits");
  if (options.encoding.jpeg_quality != defaults.encoding.jpeg_quality && kind != "jpeg")
    names.emplace_back("-jpeg_quality");
  if (options.render.budget.adaptive == Adaptive::tile && !options.render.budget.error)
    names.emplace_back("-adaptive tile");
  if (options.render.camera.focus > 0 && !options.render.camera.HasLens()) names.emplace_back("-focus");
  if (!are_devices_default && accelerator.name != defaults.accelerator.name)
    names.emplace_back("-node_boxes, -front_to_back or -last_hit");
  return names;
}

std::vector<std::string> ExplainRender(const RunStats& record) {
  const auto listed = [](const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list.empty() ? std::string("nothing") : list;
  };
  std::vector<std::string> lines{"the scene needs " + listed(record.needs), "kernel: " + record.kernel,
                                 "biased by " + listed(record.biased)};
  std::string knobs;
  for (const OptionKind& option : OptionTable(record.options.program))
    if (IsSetting(option) && std::string(option.topic) != "messages" && !Show(option, record.options).empty())
      knobs += " -" + std::string(option.name) + " " + Show(option, record.options);
  lines.push_back("every knob:" + knobs);
  return lines;
}

}  // namespace

RunLog::RunLog(const Options& options, std::span<const std::string> words) {
  record_.options = options;
  record_.command = CommandAsTyped(words);
  record_.threads = ThreadsOf(options.render);
  if (options.render.trace.max_depth > most_bounces)
    Warn("raypro: warning: -max_depth " + std::to_string(options.render.trace.max_depth) + " is more than the " +
         std::to_string(most_bounces) + " bounces that are followed at most");
  for (const std::string& name : OptionsWithoutEffect(options))
    Warn("raypro: warning: " + name + " has no effect here");
}

void RunLog::Loaded(const ParsedScene& parsed) {
  record_.seconds.load = watch_.Lap();
  for (const std::string& line : parsed.warnings) Warn(line);
  record_.scene.hash = SceneHash(parsed.scene.files);
  record_.scene.lights = static_cast<std::int64_t>(parsed.scene.lights.size());
  TellStep("read " + Counted(parsed.scene.files.size(), "file"), record_.seconds.load);
  watch_.Lap();
}

void RunLog::Built(const World& world, const Accelerator& accelerator) {
  record_.seconds.build = watch_.Lap();
  for (const std::string& line : world.Warnings()) Warn(line);
  record_.scene.nodes = static_cast<std::int64_t>(world.Nodes().size());
  record_.scene.instances = static_cast<std::int64_t>(world.Instances().size());
  record_.scene.primitives = world.Primitives();
  record_.accelerator = accelerator.kind;
  record_.structure_bytes = accelerator.Bytes();
  const SceneFeatures needs = FeaturesOf(world, record_.options.render);
  record_.needs = needs.Names();
  record_.kernel = KernelName(needs, record_.options.render);
  record_.biased = SourcesOfBias(needs, record_.options.render);
  if (record_.options.explain) {
    for (const std::string& line : accelerator.reasons) PrintError("raypro: " + line);
    for (const std::string& line : accelerator.Explain()) PrintError("raypro: " + line);
    for (const std::string& line : ExplainRender(record_)) PrintError("raypro: " + line);
  }
  TellStep(
      "built " + accelerator.kind + " over " + Counted(static_cast<std::uint64_t>(world.Primitives()), "primitive"),
      record_.seconds.build);
}

void RunLog::Compared(double true_error) { record_.true_error = true_error; }

void RunLog::Rendered(const RenderResult& result) {
  record_.seconds.render = watch_.Lap();
  record_.seconds.wall = watch_.Total();
  record_.Take(result);
  if (!result.IsComplete()) record_.stop = StopSignal() == SIGTERM ? "SIGTERM" : "SIGINT";
  if (result.has_outliers)
    Warn(
        "raypro: warning: a thousandth of the pixels holds more than half of the squared error; where light is found "
        "so "
        "seldom, the true error may be larger than it seems");
  if (result.rays.cut > 0)
    Warn("raypro: warning: " + Counted(result.rays.cut, "ray") + " were not followed; a camera ray may have at most " +
         std::to_string(most_descendants) + " descendants");
  TellStep("traced " + Counted(result.rays.Total(), "ray"), record_.seconds.render);
}

void RunLog::Written() {
  record_.seconds.write = watch_.Lap();
  record_.seconds.wall = watch_.Total();
  record_.seconds.cpu = CpuSeconds();
  record_.peak_memory = PeakMemory();
  TellStep("wrote the picture", record_.seconds.write);
  if (record_.pixels_done == 0) PrintError("raypro: stopped before the first pixel; there is no picture to save");
  if (!record_.IsComplete()) PrintError("raypro: what is done is kept beside the picture; -resume goes on from it");
}

// Nothing here may fail the run: the picture is safe.
void RunLog::Summarize() const {
  try {
    if (record_.options.stats) WriteStandardOutput(Statistics(record_));
    if (!record_.options.quiet && record_.pixels_done > 0)
      WriteStandardOutput(FinalLine(record_) + TradeLines(record_));
  } catch (const OutputError& error) {
    PrintError("raypro: " + std::string(error.what()));
  }
}

void RunLog::Warn(const std::string& line) {
  PrintError(line);
  record_.warnings.push_back(line);
}

void RunLog::TellStep(const std::string& step, double seconds) const {
  if (record_.options.verbose) PrintError(step + " in " + Fixed(seconds, 3) + " s");
}

}  // namespace ray
