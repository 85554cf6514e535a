#pragma once

#include <memory>
#include <vector>

#include "source/view/live/RenderJob.h"

namespace ray {

/// The current job, and the abandoned ones that have yet to finish the pixels they had begun, so that a new job never
/// waits for them. For one thread.
class JobQueue {
 public:
  /// Abandons the current job, if there is one, for a new one.
  RenderJob& Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, RenderJob::Order order,
                   int first_places = 1);
  /// Continues the current job, which was canceled, by a new one of the same settings.
  RenderJob& Continue(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings);
  /// Cancels the current job; then there is none.
  void Abandon();
  /// The job before the current one, where it was abandoned with something to be seen; null where there is none. It
  /// lives until the next is abandoned.
  const RenderJob* Last() const { return last_.get(); }
  void ForgetLast();
  /// The job started last; null before the first, or when it was abandoned.
  RenderJob* Current() { return current_.get(); }
  const RenderJob* Current() const { return current_.get(); }
  /// Destroys the abandoned jobs that have ended; to be called now and then. Returns how many are left.
  int Collect();

 private:
  std::unique_ptr<RenderJob> current_, last_;
  std::vector<std::unique_ptr<RenderJob>> abandoned_;
};

}  // namespace ray
