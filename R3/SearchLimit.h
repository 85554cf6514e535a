#pragma once

#include <atomic>
#include <chrono>
#include <optional>

namespace R3 {

/// A deadline and a stop flag that end long searches of this thread while the object is in scope. A search that is
/// interrupted returns a meaningless result, so callers must discard the results once the limit is reached.
class SearchLimit {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sets the limit. `stop` must outlive it, and may be null.
  SearchLimit(const std::atomic<bool>* stop, std::optional<Clock::time_point> deadline)
      : stop_(stop), deadline_(deadline), outer_(innermost) {
    innermost = this;
  }
  ~SearchLimit() { innermost = outer_; }
  SearchLimit(const SearchLimit&) = delete;

  static bool IsReached(const std::atomic<bool>* stop, const std::optional<Clock::time_point>& deadline) {
    return (stop && stop->load(std::memory_order_relaxed)) || (deadline && Clock::now() >= *deadline);
  }
  /// Returns true if the innermost limit of the thread is reached. Searches call it about every microsecond; only every
  /// 64th call of the thread reads the flag and the clock.
  static bool EndsSearches() {
    return innermost && ++asked % 64 == 0 && IsReached(innermost->stop_, innermost->deadline_);
  }

 private:
  static inline thread_local const SearchLimit* innermost = nullptr;
  static inline thread_local unsigned asked = 0;

  const std::atomic<bool>* stop_;
  std::optional<Clock::time_point> deadline_;
  const SearchLimit* outer_;
};

}  // namespace R3
