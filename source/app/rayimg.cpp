// rayimg compares, describes, converts and merges pictures, and makes movies of them. Its commands and options are in
// rayimg/Table.cpp.
#include <new>
#include <string>
#include <vector>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/rayimg/CommandLine.h"
#include "source/app/rayimg/Help.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

using Words = std::vector<std::string>;

std::string Answer(const Job& job) {
  if (job.request == "version") return Version();
  if (job.request == "complete") return CompletionScript(job.subject);
  if (job.request == "man") return ManualPage();
  return Help(job.subject);
}

int Run(const Words& words) {
  const Job job = ReadCommandLine(words);
  if (job.command) return job.command->run(job.options, "rayimg " + ShellLine(words));
  WriteStandardOutput(Answer(job));
  return status::done;
}

int Fail(int exit_status, const std::string& message) {
  PrintError(message);
  return exit_status;
}

}  // namespace
}  // namespace ray::rayimg

// The status 1 says that pictures differ, and nothing else: scripts rely on it.
int main(int argc, char** argv) {
  using namespace ray;
  GuardStandardStreams();
  try {
    return rayimg::Run(rayimg::Words(argv + (argc > 0 ? 1 : 0), argv + argc));
  } catch (const UsageError& error) {
    return rayimg::Fail(status::wrong_arguments, "rayimg: " + std::string(error.what()));
  } catch (const SceneErrors& errors) {
    return rayimg::Fail(status::bad_scene, errors.what());
  } catch (const OutputError& error) {
    return rayimg::Fail(status::cannot_write, "rayimg: " + std::string(error.what()));
  } catch (const std::bad_alloc&) {
    return rayimg::Fail(status::bad_scene, "rayimg: there is not enough memory for the pictures");
  } catch (const std::exception& error) {
    return rayimg::Fail(status::bad_scene, "rayimg: " + std::string(error.what()));
  }
}
