#include "source/app/Interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>

#include "source/app/Status.h"

namespace ray {
namespace {

// A signal handler reaches nothing but statics, and of those only what is lock-free.
std::atomic<bool> stop{false};
std::atomic<int> stop_signal{0};
std::atomic<const char*> doomed_file{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void OnInterrupt(int signal) {
  const int saved_errno = errno;
  int none = 0;
  stop_signal.compare_exchange_strong(none, signal);
  if (stop.exchange(true)) {
    if (const char* file = doomed_file.load()) unlink(file);
    _exit(status::killed_by + signal);
  }
  errno = saved_errno;
}

void Catch(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = OnInterrupt;
  action.sa_flags = SA_RESTART;  // a write in progress goes on
  sigaction(signal, &action, nullptr);
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
  // open() gives the lowest free descriptor, so this fills every gap below 3. Nothing can be written there, so
  // with standard output closed, output that goes nowhere is an error.
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
  Catch(SIGINT);
  Catch(SIGTERM);
}

const std::atomic<bool>* StopRequested() { return &stop; }
int StopSignal() { return stop_signal.load(); }
void RemoveWhenKilled(const char* file) { doomed_file.store(file); }

}  // namespace ray
