#include "source/app/Interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <stdexcept>

#include "source/app/Status.h"

namespace ray {
namespace {

// Signal handlers may use only lock-free static variables.
std::atomic<bool> stop{false}, had_urgent{false};
std::atomic<int> stop_signal{0};
std::atomic<const char*> doomed_file{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// A signal that requests a stop.
///   is_urgent   the second of these ends the program at once. Others repeat by themselves: SIGHUP from a terminal
///               and from its shell, before or after a SIGTERM, and SIGXCPU with each further second.
struct StopSignalKind {
  int number;
  const char* name;
  bool is_urgent;
};
constexpr StopSignalKind stop_signals[]{
    {SIGHUP, "SIGHUP", false}, {SIGXCPU, "SIGXCPU", false}, {SIGINT, "SIGINT", true}, {SIGTERM, "SIGTERM", true}};

template <bool is_urgent>
void OnInterrupt(int signal) {
  const int saved_errno = errno;
  int none = 0;
  stop_signal.compare_exchange_strong(none, signal);
  stop = true;
  if (is_urgent && had_urgent.exchange(true)) {
    if (const char* file = doomed_file.load()) unlink(file);
    _exit(status::killed_by + signal);
  }
  errno = saved_errno;
}

void Catch(const StopSignalKind& signal) {
  struct sigaction action = {};
  sigaction(signal.number, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = signal.is_urgent ? OnInterrupt<true> : OnInterrupt<false>;
  action.sa_flags = SA_RESTART;  // a write in progress continues
  sigaction(signal.number, &action, nullptr);
}

/// Requests SIGXCPU before the hard limit of processor time, at which the system sends SIGKILL: earlier by a tenth of
/// it, within 1 to 10 seconds, in which the image is encoded.
void StopBeforeHardLimit() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY) return;
  const rlim_t left_to_save = std::clamp<rlim_t>(limit.rlim_max / 10, 1, 10);
  if (limit.rlim_max <= left_to_save || limit.rlim_cur <= limit.rlim_max - left_to_save) return;
  limit.rlim_cur = limit.rlim_max - left_to_save;
  setrlimit(RLIMIT_CPU, &limit);
}

void Ignore(int signal) {
  struct sigaction action = {};
  action.sa_handler = SIG_IGN;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void GuardStandardStreams() {
  Ignore(SIGPIPE);
  Ignore(SIGXFSZ);
  // open() returns the lowest free descriptor, so this fills every gap below 3. Nothing can be written there, so that
  // output to a closed standard output is an error.
  int descriptor = open("/dev/null", O_RDONLY);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDONLY);
  if (descriptor >= 0) close(descriptor);
}

void RequireStack() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= needed_stack) return;  // RLIM_INFINITY is the largest
  limit.rlim_cur = std::min<rlim_t>(needed_stack, limit.rlim_max);
  if (limit.rlim_cur < needed_stack || setrlimit(RLIMIT_STACK, &limit) != 0)
    throw std::runtime_error("the stack is limited to " + std::to_string(limit.rlim_cur >> 10) + " KiB, and " +
                             std::to_string(needed_stack >> 10) + " are needed; see ulimit -s");
}

void CatchInterrupts() {
  for (const StopSignalKind& signal : stop_signals) Catch(signal);
  StopBeforeHardLimit();
}

const std::atomic<bool>* StopRequested() { return &stop; }
int StopSignal() { return stop_signal.load(); }
std::string StopSignalName() {
  const auto* const found = std::ranges::find(stop_signals, StopSignal(), &StopSignalKind::number);
  return found == std::end(stop_signals) ? "" : found->name;
}
void RemoveWhenKilled(const char* file) { doomed_file.store(file); }

}  // namespace ray
