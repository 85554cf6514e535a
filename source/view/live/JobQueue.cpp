#include "source/view/live/JobQueue.h"

namespace ray {

RenderJob& JobQueue::Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings,
                           RenderJob::Order order, int first_stride) {
  GiveUp();
  current_ = std::make_unique<RenderJob>(std::move(scene), settings, order, first_stride);
  return *current_;
}

void JobQueue::GiveUp() {
  Tidy();
  if (!current_) return;
  current_->Cancel();
  given_up_.push_back(std::move(current_));
}

int JobQueue::Tidy() {
  std::erase_if(given_up_, [](const auto& job) { return job->HasEnded(); });
  return static_cast<int>(given_up_.size());
}

}  // namespace ray
