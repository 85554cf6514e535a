#include "source/app/Farm.h"

#include <algorithm>

#include "source/app/Interrupt.h"
#include "source/app/PreparedScene.h"
#include "source/app/Status.h"
#include "source/app/files/Checkpoint.h"
#include "source/app/files/Outputs.h"
#include "source/app/files/PartFiles.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/FileNames.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Progress.h"
#include "source/app/report/Resources.h"
#include "source/render/Parts.h"
#include "source/render/SharingGain.h"
#include "source/render/forecast/FinishForecast.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// A scene of which a share is to be rendered.
struct SharedScene : ReadScene {
  explicit SharedScene(const RenderOptions& asked)
      : ReadScene(asked),
        outputs(CheckOutputs(asked.files, RegionOf(asked.render))),
        identity(IdentityOf(options, SceneHash(parsed.scene.files))) {
    RefuseInputs(outputs, parsed.scene.files);
    RefuseSize(*outputs.format, options.render.width, options.render.height);
    for (const std::string& line : parsed.warnings) PrintError(line);
  }
  Outputs outputs;
  std::string identity;  // see IdentityOf
};

/// Returns the initial state of the part: the round, with the samples of an earlier run.
RenderState BeginningOf(PartReader& reader, const RenderOptions& options, const std::string& name) {
  RenderState state = reader.Round();
  if (options.checkpoint.restart || !IsThere(name)) return state;
  auto earlier = reader.Read(name);
  if (!earlier) return state;
  if (earlier->part != *options.render.part)
    throw OutputError("cannot write " + QuotedPath(name) + ": it contains another part; -restart renders over it");
  state.rays = earlier->state.rays;
  TakeBlocks(state, std::move(earlier->state), earlier->part.index, reader.PartsOf(earlier->part.of));
  return state;
}

/// Returns the settings for the remaining time. Rendering has less time than the whole, since the process that
/// assembles the image reads and builds the scene as this one did, and filters the image.
///   before_samples   what this process took for that, in seconds
///   filters          whether to reserve time for the filters
RenderSettings SettingsInTime(const RenderOptions& options, double before_samples, bool filters) {
  constexpr double least = 1e-3;  // seconds; 0 would be no limit
  RenderSettings settings = options.render;
  Budget& budget = settings.budget = BudgetWithFinish(settings, EncoderOf(options.files.image, options.encoding));
  const double kept = before_samples + (filters ? budget.seconds_to_filter : 0);
  if (budget.seconds > 0) budget.seconds = std::max(least, budget.seconds - kept);
  return settings;
}

/// Returns true if the remaining time is at least that of the first round, which had the fewest samples.
bool HasTimeForRound(const RenderOptions& options, const PartReader& reader, const RenderState& round) {
  const double first = round.passes.empty() ? 0 : round.passes.front().seconds;
  return reader.SecondsSinceBegin().value_or(0) + first < options.render.budget.seconds;
}

/// Returns the next round after one that is complete; std::nullopt if the image is done.
///   watch   runs since the process began
std::optional<RenderState> PlannedRound(const SharedScene& scene, const PreparedScene& prepared,
                                        const PartReader& reader, RenderState&& round, const Stopwatch& watch) {
  RenderMonitor monitor;
  monitor.seconds_before = reader.SecondsSinceBegin().value_or(0);
  return NextRound(prepared.world, *prepared.accelerator, SettingsInTime(scene.options, watch.Total(), false),
                   std::move(round), monitor);
}

std::string FilesOfParts(const RenderOptions& options) {
  return options.parts.empty() ? options.files.image + ".part-*-of-" + std::to_string(options.missing) : options.parts;
}

int RenderOnePart(const RenderOptions& asked) {
  const Stopwatch watch;
  SharedScene scene(asked);
  const RenderOptions& options = scene.options;
  const std::string name = PartName(options.files.image, *options.render.part);
  CheckOutput(name, scene.parsed.scene.files);
  if (options.render.budget.seconds > 0 && !IsThere(PlanName(options.files.image)))
    throw UsageError("-part with -time needs " + QuotedPath(PlanName(options.files.image)) +
                     ", which records when the render began; -missing n writes it");
  const PreparedScene prepared(scene);
  PartReader reader(options.render, options.files.image, scene.identity);
  RenderState beginning = BeginningOf(reader, options, name);
  for (const std::string& line : prepared.world.Warnings()) PrintError(line);

  CatchInterrupts();
  Progress progress(ChooseProgressStyle(options.quiet));
  const PartWriter writer(options.render, options.files, scene.identity);
  std::uint64_t rays = 0;
  RenderMonitor monitor;
  monitor.stop = StopRequested();
  monitor.seconds_before = reader.SecondsSinceBegin().value_or(0);
  monitor.tile_done = [&](const RenderProgress& now) { progress.Update(now); };
  monitor.save_every = options.checkpoint.seconds;
  monitor.resume = [&](const Film&) { return std::move(beginning); };
  monitor.save = [&](const RenderState& state) {
    rays = state.rays.Total();
    writer.WritePart(RenderState(state));
  };
  const bool is_done =
      RenderPart(prepared.world, *prepared.accelerator, SettingsInTime(options, watch.Total(), true), monitor);
  if (!options.quiet)
    WriteStandardOutput(Escaped(name) + " " + Counted(rays, "ray") + " " + Fixed(CpuSeconds(), 2) + " s CPU" +
                        (is_done ? "" : " (stopped; the same command continues)") + "\n");
  return StopSignal() != 0 ? status::killed_by + StopSignal() : status::done;
}

void PrintMissingParts(const RenderOptions& asked) {
  const Stopwatch watch;
  SharedScene scene(asked);
  const RenderOptions& options = scene.options;
  std::optional<PreparedScene> prepared;
  if (const auto shares_light = SharesLight(options.render))
    scene.options.render.shares_light = *shares_light;
  else
    prepared.emplace(scene);
  const bool is_timed = options.render.budget.seconds > 0;
  PartReader reader(options.render, options.files.image, scene.identity);
  const PartWriter writer(options.render, options.files, scene.identity);
  if (is_timed && !reader.SecondsSinceBegin()) writer.WritePlan(reader.Round(), watch.Total());
  RenderState round = reader.Joined(FilesLike(FilesOfParts(options), options.files.image), options.missing);
  const auto lines_of = [&](const RenderState& state) {
    std::string lines;
    for (const int part : MissingParts(state, options.render, reader.PartsOf(options.missing)))
      lines += std::to_string(part) + "\n";
    return lines;
  };
  if (is_timed && !HasTimeForRound(options, reader, round)) return;
  const std::string lines = lines_of(round);
  if (!lines.empty() || IsOfOneRound(options.render, reader.film())) return WriteStandardOutput(lines);
  if (!prepared) prepared.emplace(scene);
  auto next = PlannedRound(scene, *prepared, reader, std::move(round), watch);
  if (!next || (is_timed && !HasTimeForRound(options, reader, *next))) return;
  const std::string of_next = lines_of(*next);
  // The plan is written before anyone needs it.
  writer.WritePlan(std::move(*next), is_timed ? reader.SecondsSinceBegin().value_or(0) : 0);
  WriteStandardOutput(of_next);
}

}  // namespace

int DoShareOfImage(const RenderOptions& options) {
  if (options.render.part) return RenderOnePart(options);
  PrintMissingParts(options);
  return status::done;
}

}  // namespace ray
