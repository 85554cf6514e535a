#pragma once

#include <functional>

namespace ray {

/// Returns the number of threads that can run at once, including this one, up to `wanted`. If the system limits them,
/// it is the number that could be created now; a request for more would make oneTBB throw in the middle of its work.
int ThreadsAvailable(int wanted);

/// Returns the number of threads to use if `asked` are requested; 0 requests the usual number. Creates threads to check
/// whether more than usual are possible, so call this once.
int ThreadsFor(int asked);

/// Calls task(i) once for each i in 0 .. count - 1, in any order, on the given number of threads, see ThreadsFor. Can
/// be called from several threads at once.
///   throws   the exception of a task, after all running tasks have ended
void ForEachOnThreads(int threads, int count, const std::function<void(int)>& task);

}  // namespace ray
