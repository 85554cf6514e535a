#include <new>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/app/Account.h"
#include "source/app/CommandLine.h"
#include "source/app/Interrupt.h"
#include "source/app/Messages.h"
#include "source/app/Outputs.h"
#include "source/app/Progress.h"
#include "source/app/Status.h"
#include "source/app/Tasks.h"

namespace ray {
namespace {

using Words = std::vector<std::string>;

RenderResult RenderAndTell(const World& world, const Accelerator& accelerator, const Options& options) {
  Progress progress(ChooseProgressStyle(options.quiet));
  const auto tile_done = [&](const RenderProgress& now) { progress.Update(now); };
  return Render(world, accelerator, options.render, {.stop = StopRequested(), .tile_done = tile_done});
}

std::unique_ptr<const Accelerator> Build(const World& world, const Options& options) {
  AcceleratorSettings settings = options.accelerator;
  settings.expected_rays = ExpectedRays(options.render);
  return FindAcceleratorKind(settings.name)->make(world, settings);
}

int MakePicture(const Options& options, const Words& words) {
  CheckMachine(options);
  Account account(options, words);
  const Outputs outputs = CheckOutputs(options);
  const ParsedScene parsed = Parse(options.scene, options.parse);
  RefuseInputs(outputs, parsed.scene.files);
  account.Loaded(parsed);

  const World world(parsed.scene);
  const auto accelerator = Build(world, options);
  account.Built(world, *accelerator);

  CatchInterrupts();
  const RenderResult result = RenderAndTell(world, *accelerator, options);
  account.Rendered(result);

  WritePicture(outputs, result, account.TheRecord());
  account.Written();
  WriteReport(outputs, account.TheRecord());
  account.Summarize();
  return result.IsComplete() ? status::done : status::killed_by + StopSignal();
}

int Run(const Words& words) {
  const Options options = ReadCommandLine(words);
  if (options.task == Task::render) return MakePicture(options, words);
  DoTask(options);
  return status::done;
}

int Fail(int exit_status, const std::string& message) {
  Tell(message);
  return exit_status;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) {
  using namespace ray;
  GuardStandardStreams();
  try {
    return Run(Words(argv + (argc > 0 ? 1 : 0), argv + argc));
  } catch (const UsageError& error) {
    return Fail(status::wrong_arguments, "raypro: " + std::string(error.what()));
  } catch (const SceneErrors& errors) {
    return Fail(status::bad_scene, errors.what());
  } catch (const OutputError& error) {
    return Fail(status::cannot_write, "raypro: " + std::string(error.what()));
  } catch (const std::bad_alloc&) {
    return Fail(status::failed, "raypro: there is not enough memory");
  } catch (const std::exception& error) {
    return Fail(status::failed, "raypro: " + std::string(error.what()));
  }
}
