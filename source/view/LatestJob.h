#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace ray {

/// A computation in the background, of which only the latest counts: one that begins replaces the one before, which
/// ends unseen. The destructor waits for all of them.
template <typename Result>
class LatestJob {
 public:
  /// Begins the computation and waits for a moment, so that a short one is complete when this returns.
  void Begin(std::function<Result()> compute) {
    constexpr std::chrono::milliseconds moment{20};
    Drop();
    try {
      current_ = std::async(std::launch::async, compute);
    } catch (const std::system_error&) {  // no more threads are available
      std::packaged_task<Result()> task(std::move(compute));
      current_ = task.get_future();
      task();
    }
    current_.wait_for(moment);
  }
  void Drop() {
    std::erase_if(dropped_, [](const auto& job) { return IsComplete(job); });
    if (current_.valid()) dropped_.push_back(std::move(current_));
  }
  bool IsBusy() const { return current_.valid(); }
  bool IsComplete() const { return IsBusy() && IsComplete(current_); }
  /// Returns the result, once; std::nullopt if there is none, or if it is not complete and need not be waited for.
  /// Throws what the computation has thrown.
  std::optional<Result> Take(bool waits = false) {
    if (!IsBusy() || (!waits && !IsComplete())) return {};
    return current_.get();
  }

 private:
  static bool IsComplete(const std::future<Result>& job) {
    return job.wait_for(std::chrono::seconds{0}) == std::future_status::ready;
  }

  std::future<Result> current_;
  std::vector<std::future<Result>> dropped_;
};

}  // namespace ray
