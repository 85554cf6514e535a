#pragma once

#include <atomic>
#include <string>

/// Stop requests by signal.
namespace ray {

/// Makes the program outlive its terminal and its readers: writing to a closed pipe or beyond a file size limit is an
/// error to be reported, not a signal; and descriptors 0, 1 and 2 are open, so that no picture is ever opened as one.
/// One that was closed reads as empty and refuses whatever is written.
void GuardStandardStreams();

/// The stack that the programs need for anything they are given: 88 KiB are used at most (measured by ulimit -s), and
/// scenes are walked without recursion.
inline constexpr long needed_stack = 256 << 10;

/// Raises the limit of the stack to what is needed where it is lower, as far as the system lets it. Throws
/// std::runtime_error, which names both, where it does not.
void RequireStack();

/// Lets SIGINT, SIGTERM, SIGHUP and SIGXCPU set *StopRequested(). A second SIGINT or SIGTERM ends the program at once.
/// A signal that is ignored already (nohup, a background job of a script) stays ignored.
void CatchInterrupts();
const std::atomic<bool>* StopRequested();
/// The signal that asked to stop, 0 while none has.
int StopSignal();
/// Returns its name, such as "SIGINT"; empty while none has.
std::string StopSignalName();

/// The file a second signal removes before it ends the program; null for none. The text must outlive its turn.
void RemoveWhenKilled(const char* file);

}  // namespace ray
