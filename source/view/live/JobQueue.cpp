#include "source/view/live/JobQueue.h"

namespace ray {

RenderJob& JobQueue::Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings,
                           RenderJob::Order order, int first_stride) {
  Abandon();
  current_ = std::make_unique<RenderJob>(std::move(scene), settings, order, first_stride);
  return *current_;
}

void JobQueue::Abandon() {
  Collect();
  if (!current_) return;
  current_->Cancel();
  abandoned_.push_back(std::move(current_));
}

int JobQueue::Collect() {
  std::erase_if(abandoned_, [](const auto& job) { return job->HasEnded(); });
  return static_cast<int>(abandoned_.size());
}

}  // namespace ray
