#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/app/Answers.h"
#include "source/app/Farm.h"
#include "source/app/GuardedMain.h"
#include "source/app/Interrupt.h"
#include "source/app/PreparedScene.h"
#include "source/app/Status.h"
#include "source/app/files/Checkpoint.h"
#include "source/app/files/LayerImages.h"
#include "source/app/files/Outputs.h"
#include "source/app/files/PartFiles.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/Comp30019.h"
#include "source/app/options/FileNames.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Progress.h"
#include "source/app/report/ReadReplay.h"
#include "source/app/report/RunLog.h"
#include "source/parse/SceneError.h"
#include "source/render/Flare.h"
#include "source/render/forecast/FinishForecast.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

using Words = std::vector<std::string>;

RenderResult RenderAndLog(const World& world, const Accelerator& accelerator, const RenderOptions& options,
                          RunLog& run_log, Checkpoint* checkpoint) {
  const std::string identity = IdentityOf(options, run_log.stats().scene.hash);
  RenderSettings settings = options.render;
  settings.replay = ReadReplay(run_log.stats());
  if (settings.replay) settings.shares_light = settings.replay->shares_light;
  RenderMonitor monitor;
  monitor.encode = EncoderOf(options.files.image, options.encoding);
  settings.budget = BudgetWithFinish(settings, monitor.encode);
  if (settings.budget.seconds > 0) run_log.WillFinishIn(settings.budget);
  Progress progress(ChooseProgressStyle(options.quiet));
  const auto tile_done = [&](const RenderProgress& now) { progress.Update(now); };
  monitor.stop = StopRequested();
  monitor.tile_done = tile_done;
  monitor.seconds_before = run_log.SecondsSoFar();
  const auto parts = [&] { return PartReader(options.render, options.files.image, identity); };
  if (settings.budget.seconds > 0 && !options.parts.empty())
    if (const auto since_begin = parts().SecondsSinceBegin()) {
      monitor.seconds_before = *since_begin;
      run_log.BeganTogether(*since_begin);
    }
  if (checkpoint) monitor.save = [&](const RenderState& state) { checkpoint->Save(state, identity); };
  monitor.save_every = options.checkpoint.seconds;
  monitor.saves_finished = options.checkpoint.keep;
  if (options.checkpoint.resume && checkpoint->Exists())
    monitor.resume = [&](const Film& film) { return checkpoint->Load(film, settings, identity); };
  else if (!options.parts.empty())
    monitor.resume = [&](const Film&) { return StateOfParts(parts(), options.parts); };
  else if (options.checkpoint.resume && !options.quiet)
    PrintError("raypro: nothing to resume, " + QuotedPath(checkpoint->Name()) +
               " does not exist: rendering from the start");
  return Render(world, accelerator, settings, monitor);
}

std::vector<R2::Image> RenderLayers(const World& world, const Accelerator& accelerator, const RenderOptions& options) {
  std::vector<R2::Image> layers;
  for (const Layer layer : options.files.layers)
    layers.push_back(layer == Layer::flare
                         ? FlareAlone(world, accelerator, options.render)
                         : Render(world, accelerator, SettingsForLayer(options.render, layer)).image);
  return layers;
}

/// Compares with references, if there are any, and reports the true error.
void Compare(const RenderResult& result, const std::vector<R2::Image>& references, const RenderOptions& options,
             RunLog& run_log) {
  if (references.empty()) return;
  const ErrorMeasure measure{.unit = result.error ? result.error->unit : ErrorUnit::display,
                             .srgb = options.render.srgb};
  run_log.Compared(TrueError(result.image, references[0], references.size() > 1 ? &references[1] : nullptr, measure));
}

int MakeImage(const RenderOptions& asked, const Words& words) {
  RunLog run_log(words);
  const Outputs outputs = CheckOutputs(asked.files, RegionOf(asked.render));
  ReadScene read(asked);
  const RenderOptions& options = read.options;
  RefuseInputs(outputs, read.parsed.scene.files);
  RefuseSize(*outputs.format, options.render.width, options.render.height);
  const auto checkpoint = outputs.image.is_standard_output
                              ? nullptr
                              : std::make_unique<Checkpoint>(options.files, options.checkpoint, options.as_course);
  const std::vector<R2::Image> references = ReadReferences(options.files.reference, RegionOf(options.render));
  run_log.Loaded(read.parsed, options);
  const PreparedScene scene(read);
  const auto& [world, accelerator] = scene;
  run_log.Built(world, *accelerator, options.render.shares_light);

  if (options.checkpoint.restart) checkpoint->Remove();
  CatchInterrupts();
  const RenderResult result = RenderAndLog(world, *accelerator, options, run_log, checkpoint.get());
  run_log.Rendered(result);
  Compare(result, references, options, run_log);

  const auto layers = result.IsComplete() ? RenderLayers(world, *accelerator, options) : std::vector<R2::Image>{};
  run_log.Written(WriteImage(outputs, result, layers, run_log.stats()).name);
  if (result.IsComplete() && checkpoint) checkpoint->ImageIsFinished(options.checkpoint.keep);
  run_log.ExplainIfBlack(world, *accelerator, result.image);
  WriteReport(outputs, run_log.stats());
  run_log.Summarize();
  if (!result.IsComplete()) return status::killed_by + StopSignal();
  return result.denoise_failure.empty() ? status::done : status::failed;
}

int DoOne(const RenderOptions& options, const Words& words) {
  if (options.request) {
    AnswerRequest(options);
    return status::done;
  }
  return options.render.part || options.missing > 0 ? DoShareOfImage(options) : MakeImage(options, words);
}

/// Returns every file from which one of the scenes is read. Scenes that cannot be read report that later.
std::vector<std::string> InputsOfAll(const RenderOptions& all) {
  std::vector<std::string> inputs;
  for (const std::string& scene : all.scenes) {
    inputs.push_back(scene);
    try {
      const ParsedScene parsed = Parse(scene, all.parse);
      inputs.insert(inputs.end(), parsed.scene.files.begin(), parsed.scene.files.end());
    } catch (const SceneErrors&) {
    }
  }
  return inputs;
}

/// Returns true if the image, or a file written with it, would replace an existing file.
bool ReplacesAny(const Outputs& outputs) {
  const auto is_there = [](const OutputFile& output) { return std::filesystem::exists(output.target); };
  return is_there(outputs.image) || is_there(outputs.partial) || std::ranges::any_of(outputs.layers, is_there);
}

/// The input files of all scenes, since the image of one scene must not overwrite the texture of the next. Reading all
/// scenes before the first render takes time, so it happens only if a file would be replaced.
class InputsOfBatch {
 public:
  explicit InputsOfBatch(const RenderOptions& all) : all_(all) {}

  /// Throws OutputError if an output of the scene is an input of any scene.
  void Protect(const RenderOptions& one) {
    const Outputs outputs = CheckOutputs(one.files, RegionOf(one.render));
    if (!ReplacesAny(outputs)) return;
    if (!inputs_) inputs_ = InputsOfAll(all_);
    RefuseInputs(outputs, *inputs_);
  }

 private:
  const RenderOptions& all_;
  std::optional<std::vector<std::string>> inputs_;
};

/// Renders the scenes independently: an error in one does not stop the others.
int DoEach(const RenderOptions& all, const Words& words) {
  if (!std::filesystem::is_directory(all.out_folder))
    throw OutputError("cannot write into " + Quoted(all.out_folder) + ": there is no such folder");
  int first_failure = status::done;
  InputsOfBatch inputs(all);
  for (const std::string& scene : all.scenes) {
    RenderOptions one = all;
    one.files.scene = scene;
    one.files.image = ImageInFolder(all.out_folder, scene, all.out_format);
    const int ended = Guarded(Program::raypro, [&] {
      if (!one.request)
        inputs.Protect(one);
      else if (!one.quiet)
        WriteStandardOutput(Escaped(scene) + "\n");
      return DoOne(one, words);
    });
    if (StopSignal() != 0) return ended;
    if (first_failure == status::done) first_failure = ended;
  }
  return first_failure;
}

int Run(const RenderOptions& options, const Words& words) {
  return options.scenes.empty() ? DoOne(options, words) : DoEach(options, words);
}

int RunAsRaypro(const Words& words) { return Run(ReadCommandLine(Program::raypro, words), words); }
int RunAsComp30019(const Words& words) { return Run(comp30019::ReadCommandLine(words), comp30019::WithRequest(words)); }

}  // namespace
}  // namespace ray

int main(int argc, char** argv) {
  using namespace ray;
  ReserveMemory();
  bool is_of_course = false;
  const auto look = [&] { return is_of_course = comp30019::IsAskedFor(argc, argv), status::done; };
  if (const int failed = Guarded(Program::raypro, look)) return failed;
  if (!is_of_course) return GuardedMain(Program::raypro, argc, argv, RunAsRaypro);
  // The course has only two statuses.
  const int ended = GuardedMain(Program::raypro, argc, argv, RunAsComp30019);
  return ended == status::done ? status::done : status::failed;
}
