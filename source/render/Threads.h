#pragma once

#include <functional>

namespace ray {

/// How many threads can run at once, counting this one, and at most `wanted`: if the system limits them, as many as
/// could be made just now. oneTBB, asked for more, would throw in the middle of its work.
int ThreadsAvailable(int wanted);

/// How many threads to work with if `asked` are requested; 0 requests the usual number. To see whether more than usual
/// are possible they are made, so call this once.
int ThreadsFor(int asked);

/// task(i) for i in 0 .. count - 1, each once and in no order, by so many threads, see ThreadsFor. Others may do so
/// beside it.
///   throws   what a task threw, when those that were begun have ended
void ForEachOnThreads(int threads, int count, const std::function<void(int)>& task);

}  // namespace ray
