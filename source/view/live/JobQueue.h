#pragma once

#include <memory>
#include <vector>

#include "source/view/live/RenderJob.h"

namespace ray {

/// The job that is shown, and those given up that have yet to finish the pixels they had begun, so that a new one never
/// waits for them. For one thread.
class JobQueue {
 public:
  /// Gives up the current job, if there is one, for a new one.
  RenderJob& Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, RenderJob::Order order,
                   int first_stride = 8);
  /// Cancels it; then there is none.
  void GiveUp();
  /// The one started last; null before the first, or when it was given up.
  RenderJob* Current() { return current_.get(); }
  const RenderJob* Current() const { return current_.get(); }
  /// Destroys those given up that have ended; now and then. How many are left.
  int Tidy();

 private:
  std::unique_ptr<RenderJob> current_;
  std::vector<std::unique_ptr<RenderJob>> given_up_;
};

}  // namespace ray
