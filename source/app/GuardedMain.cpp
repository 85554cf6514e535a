#include "source/app/GuardedMain.h"

#include <new>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"

namespace ray {
namespace {

int Fail(int exit_status, const std::string& message) {
  PrintError(message);
  return exit_status;
}

}  // namespace

int GuardedMain(Program program, int argc, char** argv, int (*run)(const std::vector<std::string>& words)) {
  GuardStandardStreams();
  const std::string name = NameOf(program) + ": ";
  // rayimg's 1 says that pictures differ, and nothing else: scripts rely on it.
  const int failed = program == Program::rayimg ? status::bad_scene : status::failed;
  try {
    RequireStack();
    return run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
  } catch (const UsageError& error) {
    return Fail(status::wrong_arguments, name + error.what());
  } catch (const SceneErrors& errors) {
    return Fail(status::bad_scene, errors.what());
  } catch (const OutputError& error) {
    return Fail(status::cannot_write, name + error.what());
  } catch (const std::bad_alloc&) {
    return Fail(failed, name + "there is not enough memory");
  } catch (const std::exception& error) {
    return Fail(failed, name + error.what());
  }
}

}  // namespace ray
