#include "source/render/Threads.h"

#include <tbb/info.h>

#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace ray {

int ThreadsAvailable(int wanted) {
  std::vector<std::jthread> others;
  std::atomic<bool> all_are_made = false;
  try {
    while (static_cast<int>(others.size()) < wanted - 1) others.emplace_back([&] { all_are_made.wait(false); });
  } catch (const std::system_error&) {  // no more of them
  }
  all_are_made = true;
  all_are_made.notify_all();
  return static_cast<int>(others.size()) + 1;
}

int ThreadsFor(int asked) {
  const int usual = tbb::info::default_concurrency();
  return asked > usual ? ThreadsAvailable(asked) : asked > 0 ? asked : usual;
}

}  // namespace ray
