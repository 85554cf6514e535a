#pragma once

#include <cstddef>
#include <list>

/// oneTBB's interface for a single thread: loops run in order, and tasks at once. An instance of WebAssembly without
/// shared memory has one thread.
namespace tbb {

template <typename Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, std::size_t = 1) : begin_(begin), end_(end) {}
  Index begin() const { return begin_; }
  Index end() const { return end_; }

 private:
  Index begin_, end_;
};

struct simple_partitioner {};

template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body, const simple_partitioner& = {}) {
  for (Index i = first; i < last; ++i) body(i);
}
template <typename Index, typename Body>
void parallel_for(const blocked_range<Index>& range, const Body& body) {
  if (range.begin() < range.end()) body(range);
}

template <typename Range, typename Value, typename Body, typename Join>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body, const Join&) {
  return range.begin() < range.end() ? body(range, identity) : identity;
}

class task_group {
 public:
  template <typename Task>
  void run(const Task& task) {
    task();
  }
  void wait() {}
};

class task_arena {
 public:
  explicit task_arena(int) {}
  template <typename Work>
  void execute(const Work& work) {
    work();
  }
};

namespace this_task_arena {
template <typename Work>
void isolate(const Work& work) {
  work();
}
}  // namespace this_task_arena

/// Holds one value, made when it is first asked for.
template <typename T>
class enumerable_thread_specific {
 public:
  T& local() {
    if (values_.empty()) values_.emplace_back();
    return values_.front();
  }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }

 private:
  std::list<T> values_;
};

struct global_control {
  enum Parameter { max_allowed_parallelism };
  global_control(Parameter, std::size_t) {}
  static std::size_t active_value(Parameter) { return 1; }
};

namespace info {
inline int default_concurrency() { return 1; }
}  // namespace info

}  // namespace tbb
