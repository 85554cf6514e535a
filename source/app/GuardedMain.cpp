#include "source/app/GuardedMain.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/render/Threads.h"
#include "source/text/LookAlike.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

int Fail(int exit_status, const std::string& message) {
  PrintFailure(message);
  return exit_status;
}

// Released when memory runs out: destructors that allocate, as those of nlohmann's JSON do, cannot fail, and the rest
// is used to format messages and remove partially written files. 1 MiB is more than destroying a report of a million
// blocks of 8x8 pixels takes at a time; it is never written to, so that it costs no memory.
constexpr std::size_t reserve_bytes = std::size_t{1} << 20;
std::atomic<void*> reserve{nullptr};

/// Handler for operator new, which retries when this returns.
void GiveReserveBack() {
  void* const given = reserve.exchange(nullptr);
  if (!given) throw std::bad_alloc();
  std::free(given);
}

/// Keeps oneTBB from requesting more threads than the system allows.
void LimitThreads(const std::string& program) {
  const int usual = tbb::info::default_concurrency(), threads = ThreadsAvailable(usual);
  if (threads == usual) return;
  PrintError(program + "warning: the system allows " + Counted(static_cast<std::uint64_t>(threads), "thread") +
             " instead of " + std::to_string(usual) + "; continuing with that");
  // Static, because oneTBB would create more threads after its destruction.
  static const auto* const limit =
      new tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  (void)limit;
}

/// Returns the message with a hint if it quotes a word with look-alike characters.
std::string WithLookAlikes(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::string hint = LookAlikeHint(word);
    const bool is_said = message.find("U+") != std::string::npos || message.find(Escaped(word)) == std::string::npos;
    if (!hint.empty() && !is_said) return message + "; " + hint;
  }
  return message;
}

}  // namespace

void ReserveMemory() {
  if (reserve.load()) return;
  reserve = std::malloc(reserve_bytes);
  std::set_new_handler(GiveReserveBack);
}

int Guarded(const Program& program, const std::function<int()>& run) {
  const std::string name = NameOf(program) + ": ";
  try {
    return run();
  } catch (const UsageError& error) {
    return Fail(status::wrong_arguments, name + error.what());
  } catch (const SceneErrors& errors) {
    return Fail(status::bad_scene, errors.what());
  } catch (const OutputError& error) {
    return Fail(status::cannot_write, name + error.what());
  } catch (const std::bad_alloc&) {
    return Fail(program.failed, name + "not enough memory");
  } catch (const std::exception& error) {
    return Fail(program.failed, name + error.what());
  }
}

int GuardedMain(const Program& program, int argc, char** argv, int (*run)(const std::vector<std::string>& words)) {
  ReserveMemory();
  GuardStandardStreams();
  return Guarded(program, [&] {
    RequireStack();
    LimitThreads(NameOf(program) + ": ");
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    try {
      return run(words);
    } catch (const UsageError& error) {
      throw UsageError(WithLookAlikes(error.what(), words));
    }
  });
}

}  // namespace ray
