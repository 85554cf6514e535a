#include "source/app/Farm.h"

#include "source/app/BuildAccelerator.h"
#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/Outputs.h"
#include "source/app/files/PartFiles.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Memory.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Progress.h"
#include "source/app/report/Resources.h"
#include "source/render/Parts.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// A scene that is read, and the options once it has had its say.
struct ReadScene {
  explicit ReadScene(const Options& asked)
      : outputs(CheckOutputs(asked)),
        parsed(Parse(asked.scene, asked.parse)),
        options(WithSettingsOf(parsed.scene, asked)),
        hash(SceneHash(parsed.scene.files)) {
    RefuseInputs(outputs, parsed.scene.files);
    RefuseSize(*outputs.format, options.render.width, options.render.height);
    for (const std::string& line : parsed.warnings) PrintError(line);
  }
  Outputs outputs;
  ParsedScene parsed;
  Options options;
  std::string hash;
};

/// What the part begins with: the round, with what an earlier run left of it.
RenderState BeginningOf(PartReader& reader, const Options& options, const std::string& name) {
  RenderState state = reader.Round();
  if (options.restart || !IsThere(name)) return state;
  auto earlier = reader.Read(name);
  if (!earlier) return state;
  if (earlier->part != *options.render.part)
    throw OutputError("cannot write " + QuotedPath(name) + ": it holds another part; -restart renders over it");
  state.rays = earlier->state.rays;
  TakeBlocks(state, std::move(earlier->state), earlier->part.index, reader.PartsOf(earlier->part.of));
  return state;
}

std::string FilesOfParts(const Options& options) {
  return options.parts.empty() ? options.picture + ".part-*-of-" + std::to_string(options.missing) : options.parts;
}

}  // namespace

int RenderOnePart(const Options& asked) {
  CheckMachine(asked);
  const ReadScene scene(asked);
  const Options& options = scene.options;
  const std::string name = PartName(options.picture, *options.render.part);
  const World world(scene.parsed.scene);
  for (const std::string& line : world.Warnings()) PrintError(line);
  CheckMemory(world, options);
  CheckOutput(name, scene.parsed.scene.files);
  PartReader reader(options, scene.hash);
  RenderState beginning = BeginningOf(reader, options, name);
  const auto accelerator = BuildAccelerator(world, options);

  CatchInterrupts();
  Progress progress(ChooseProgressStyle(options.quiet));
  const PartWriter writer(options, scene.hash);
  std::uint64_t rays = 0;
  RenderMonitor monitor;
  monitor.stop = StopRequested();
  monitor.tile_done = [&](const RenderProgress& now) { progress.Update(now); };
  monitor.save_every = options.checkpoint;
  monitor.resume = [&](const Film&) { return std::move(beginning); };
  monitor.save = [&](const RenderState& state) {
    rays = state.rays.Total();
    writer.WritePart(RenderState(state));
  };
  const bool is_done = RenderPart(world, *accelerator, options.render, monitor);
  if (!options.quiet)
    WriteStandardOutput(Escaped(name) + " " + Counted(rays, "ray") + " " + Fixed(CpuSeconds(), 2) + " s CPU" +
                        (is_done ? "" : " (stopped; the same command continues)") + "\n");
  return StopSignal() != 0 ? status::killed_by + StopSignal() : status::done;
}

void PrintMissingParts(const Options& asked) {
  const ReadScene scene(asked);
  const Options& options = scene.options;
  PartReader reader(options, scene.hash);
  RenderState round = reader.Joined(FilesLike(FilesOfParts(options)), options.missing);
  const auto lines_of = [&](const RenderState& state) {
    std::string lines;
    for (const int part : MissingParts(state, options.render, reader.PartsOf(options.missing)))
      lines += std::to_string(part) + "\n";
    return lines;
  };
  const std::string lines = lines_of(round);
  if (!lines.empty() || IsOfOneRound(options.render, reader.film())) return WriteStandardOutput(lines);
  const World world(scene.parsed.scene);
  CheckMemory(world, options);
  const auto accelerator = BuildAccelerator(world, options);
  auto next = NextRound(world, *accelerator, options.render, std::move(round));
  if (!next) return;
  const std::string of_next = lines_of(*next);
  PartWriter(options, scene.hash).WritePlan(std::move(*next));  // before anyone is told to follow it
  WriteStandardOutput(of_next);
}

}  // namespace ray
