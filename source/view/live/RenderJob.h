#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "source/draw/Frame.h"
#include "source/inspect/LoadedScene.h"
#include "source/render/Render.h"

namespace ray {

class FirstLook;

/// An image rendered in the background of the thread that shows it. Each job owns its frame, so that an abandoned job
/// may end at any time: its later pixels are not shown.
class RenderJob {
 public:
  /// coarse_first   first looks at the image, each at four times as many pixels as the one before, see FirstLook, where
  ///                there are many lights with one of them per point; then more samples, twice as many pass by pass,
  ///                until the budget or the count of samples is reached
  /// rows           in rows of blocks of the film from the bottom, each with all its samples; all at once if
  ///                pixels depend on their neighbors
  enum class Order { coarse_first, rows };

  /// The state of a canceled job, from which another can continue.
  struct Stopped {
    RenderState state;
    double seconds = 0;
    // In order coarse_first.
    R2::Image image{};
    int samples = 0;
  };

  /// Starts at once. `settings.view` is the camera if it is not the scene's. Without `settings.threads` one core is
  /// left to the calling thread until each pixel has its first sample, in order coarse_first. Time counts from the
  /// start of the job, and ends no earlier than with that sample. In order rows, limits of budgets and replays are
  /// ignored. `first_places`: pixels of each block in the first look. `before`: continues a job of the same scene,
  /// settings and order; time counts on. The result is that of a job that was never canceled.
  RenderJob(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, Order order, int first_places = 1,
            std::optional<Stopped> before = {});
  /// Cancels, and waits for the pixels that were started.
  ~RenderJob();
  RenderJob(const RenderJob&) = delete;

  /// Stops it: no further pixel is started. Returns at once.
  void Cancel() { stop_.store(true); }
  /// Returns true if the job is complete, canceled or failed.
  bool HasEnded() const { return has_ended_.load(std::memory_order_acquire); }
  /// Returns true if HasEnded with every sample taken.
  bool IsComplete() const;
  /// Returns why it failed, once it HasEnded; empty if it did not.
  std::string Failure() const;
  /// The finished image, the same bit for bit as Render's; null unless IsComplete.
  const RenderResult* Result() const;

  /// The image so far: of the crop, or of the whole.
  const Frame& frame() const { return frame_; }
  const RenderSettings& Settings() const { return settings_; }
  Order order() const { return order_; }
  const LoadedScene& scene() const { return *scene_; }
  const std::shared_ptr<const LoadedScene>& SharedScene() const { return scene_; }
  /// The number of complete rows, from the bottom (order rows).
  int RowsDone() const { return rows_done_.load(std::memory_order_acquire); }
  /// The pixels of each block that have their first sample; 0 before the first look is whole.
  int Places() const { return places_.load(std::memory_order_acquire); }
  /// Samples per pixel of the frame: their mean once it is complete, their maximum before.
  int Samples() const { return samples_.load(std::memory_order_acquire); }
  /// Returns its state when it was canceled; none if that was no sample of a pixel beyond the first look, or it did not
  /// end so.
  const std::optional<Stopped>& Canceled() const;
  /// Returns true if points of the image so far are lit by one light each, chosen by importance, though the settings
  /// sample more.
  bool IsOfOneLight() const { return is_of_one_light_.load(std::memory_order_acquire); }
  std::uint64_t Rays() const { return rays_.load(std::memory_order_relaxed); }
  /// Since the start, until the end.
  double Seconds() const;
  /// Returns the share of all samples, or of the time, that is done, from 0 to 1; std::nullopt if no end is known.
  std::optional<double> Share() const;
  /// Returns the seconds until the end at the current pace; std::nullopt if they are not known.
  std::optional<double> SecondsLeft() const;
  /// First samples traced per second, up to the last look that is whole; 0 before the first. For PlacesWithin.
  double PixelsPerSecond() const { return pixels_per_second_.load(std::memory_order_relaxed); }

 private:
  void Run();
  std::optional<RenderResult> RenderCoarseFirst(const Integrator& integrator);
  /// Looks at a quarter of the pixels with one light per point; false where it was stopped.
  bool LookByOneLight();
  /// Takes the first sample of each pixel, look by look; false where it was stopped.
  bool LookFirst(FirstLook& look, bool is_kept);
  RenderSettings DecidedSettings() const;
  RenderResult RenderAll(const Integrator& integrator, const RenderSettings& settings,
                         const RenderMonitor& monitor) const;
  std::optional<RenderResult> RenderRows(const Integrator& integrator);

  using Clock = std::chrono::steady_clock;
  std::optional<Stopped> before_;
  const Clock::time_point start_;
  const std::shared_ptr<const LoadedScene> scene_;
  const RenderSettings settings_;
  const Order order_;
  const int threads_of_further_samples_;  // 0: as many as the machine has
  const int first_places_;
  Frame frame_;
  std::atomic<bool> stop_ = false, has_ended_ = false, is_of_one_light_ = false;
  std::atomic<int> rows_done_ = 0, places_ = 0, samples_ = 0;
  std::atomic<std::uint64_t> rays_ = 0;
  std::atomic<double> pixels_per_second_ = 0, share_ = 0;
  // Written before has_ended_, read after.
  std::optional<RenderResult> result_;
  std::optional<Stopped> canceled_;
  std::string failure_;
  double seconds_ = 0;
  std::thread thread_;  // the last, so that the other members exist when it starts
};

/// The current job, and the abandoned ones that have yet to finish the pixels they had begun, so that a new job never
/// waits for them. For one thread.
class JobQueue {
 public:
  /// Abandons the current job, if there is one, for a new one, which may continue it.
  RenderJob& Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, RenderJob::Order order,
                   int first_places = 1, std::optional<RenderJob::Stopped> before = {});
  /// Cancels the current job.
  void Abandon();
  /// The job before the current one, if it was abandoned with something to show; null otherwise. It
  /// lives until the next is abandoned.
  const RenderJob* Last() const { return last_.get(); }
  void ForgetLast();
  /// The job started last; null before the first, or when it was abandoned.
  RenderJob* Current() { return current_.get(); }
  const RenderJob* Current() const { return current_.get(); }
  /// Destroys abandoned jobs that have ended; to be called regularly. Returns the number of those left.
  int Collect();

 private:
  std::unique_ptr<RenderJob> current_, last_;
  std::vector<std::unique_ptr<RenderJob>> abandoned_;
};

}  // namespace ray
