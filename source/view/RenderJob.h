#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "source/render/Render.h"
#include "source/view/Frame.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// A picture being traced beside the thread that shows it. Each job owns its frame, so that a job that was given up may
/// end when it likes: nobody looks at what it still writes.
class RenderJob {
 public:
  /// coarse_first   pixels 8 apart (or more, see first_stride), then 4, 2 and 1 apart, each traced once; then more
  ///                samples pass by pass
  /// rows           row by row from the bottom, each with all its samples; with a filter wider than a pixel in bands
  enum class Order { coarse_first, rows };

  /// Starts at once. `settings.view` is the camera if it is not the scene's.
  RenderJob(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, Order order,
            int first_stride = 8);
  /// Cancels, and waits for the pixels that were begun.
  ~RenderJob();
  RenderJob(const RenderJob&) = delete;

  /// From now on no pixel is begun. Returns at once.
  void Cancel() { stop_.store(true); }
  /// Whether nothing will change any more: it is complete, cancelled or failed.
  bool HasEnded() const { return has_ended_.load(std::memory_order_acquire); }
  /// Whether HasEnded with every sample taken.
  bool IsComplete() const;
  /// Why it failed; empty when it did not. Once it HasEnded.
  std::string Failure() const;
  /// The finished picture, the same bit for bit as Render's; nothing unless IsComplete.
  const RenderResult* Result() const;

  const Frame& TheFrame() const { return frame_; }
  const RenderSettings& Settings() const { return settings_; }
  /// Rows from the bottom that will not change any more (order rows).
  int RowsDone() const { return rows_done_.load(std::memory_order_acquire); }
  /// Pixels apart of the last pass that is whole; 0 before the first.
  int Stride() const { return stride_.load(std::memory_order_acquire); }
  /// Samples a pixel that the frame shows, where it is whole.
  int Samples() const { return samples_.load(std::memory_order_acquire); }
  std::uint64_t Rays() const { return rays_.load(std::memory_order_relaxed); }
  /// Since the start, until the end.
  double Seconds() const;
  /// Pixels handed to the tracer after Cancel was seen to be asked for: 0, always. For tests.
  std::int64_t PixelsBegunAfterCancel() const { return begun_late_.load(); }
};

}  // namespace ray
