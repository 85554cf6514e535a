#include "source/render/Threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace ray {

int ThreadsAvailable(int wanted) {
  std::vector<std::jthread> others;
  std::atomic<bool> all_are_made = false;
  try {
    while (static_cast<int>(others.size()) < wanted - 1) others.emplace_back([&] { all_are_made.wait(false); });
  } catch (const std::system_error&) {  // no more are available
  }
  all_are_made = true;
  all_are_made.notify_all();
  return static_cast<int>(others.size()) + 1;
}

int ThreadsFor(int asked) {
  const int usual = tbb::info::default_concurrency();
  return asked > usual ? ThreadsAvailable(asked) : asked > 0 ? asked : usual;
}

void ForEachOnThreads(int threads, int count, const std::function<void(int)>& task) {
  // The arena limits this work alone; only more threads than usual require a global permission.
  std::optional<tbb::global_control> permission;
  if (threads > tbb::info::default_concurrency())
    permission.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(
        0, count, [&](int i) { task(i); }, tbb::simple_partitioner());
  });
}

}  // namespace ray
