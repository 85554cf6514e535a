#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>

namespace ray {

/// The progress of work that threads share, and the request to stop it.
class WorkMeter {
 public:
  /// A callback for progress: `done` of `total` parts are finished. Called by one thread at a time.
  using Listener = std::function<void(std::int64_t done, std::int64_t total)>;

  /// A meter without a listener.
  WorkMeter() = default;
  /// The listener may be empty, `stop` null.
  WorkMeter(Listener listener, const std::atomic<bool>* stop) : listener_(std::move(listener)), stop_(stop) {}

  /// Sets the number of parts, as soon as it is known.
  void Expect(std::int64_t parts) { total_ = parts; }
  void PartIsDone() {
    if (!listener_) return;
    const std::lock_guard lock(mutex_);
    listener_(++done_, total_);
  }
  /// Returns true if the work is no longer needed, so that loops may end early.
  bool IsStopped() const { return stop_ && stop_->load(std::memory_order_relaxed); }

 private:
  Listener listener_;
  const std::atomic<bool>* stop_ = nullptr;
  std::mutex mutex_;
  std::int64_t done_ = 0, total_ = 1;
};

}  // namespace ray
