#pragma once

#include <atomic>
#include <string>

/// Stop requests by signal.
namespace ray {

/// Makes the program outlive its terminal and its readers. Writing to a closed pipe or beyond a file size limit becomes
/// an error to report, not a signal. Descriptors 0, 1 and 2 are open, so that no image is ever opened as one of them;
/// one that was closed reads as empty and rejects writes.
void GuardStandardStreams();

/// The stack that the programs need for any input: at most 88 KiB are used (measured by ulimit -s), and scenes are
/// traversed without recursion.
inline constexpr long needed_stack = 256 << 10;

/// Raises the limit of the stack to this size if it is lower. If the system does not allow that, throws
/// std::runtime_error with both sizes.
void RequireStack();

/// Lets SIGINT, SIGTERM, SIGHUP and SIGXCPU set *StopRequested(). A second SIGINT or SIGTERM ends the program at once.
/// Signals that are already ignored (nohup, a background job of a script) stay ignored.
void CatchInterrupts();
const std::atomic<bool>* StopRequested();
/// Returns the signal that requested a stop, 0 if there was none.
int StopSignal();
/// Returns its name, such as "SIGINT"; empty if there was none.
std::string StopSignalName();

/// Sets the file that a second signal removes before it ends the program; null for none. The text must outlive its use.
void RemoveWhenKilled(const char* file);

}  // namespace ray
