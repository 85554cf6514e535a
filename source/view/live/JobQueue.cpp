#include "source/view/live/JobQueue.h"

#include <cassert>

namespace ray {

RenderJob& JobQueue::Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings,
                           RenderJob::Order order, int first_places) {
  Abandon();
  current_ = std::make_unique<RenderJob>(std::move(scene), settings, order, first_places);
  return *current_;
}

RenderJob& JobQueue::Continue(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings) {
  assert(current_ && current_->Canceled());
  current_ = std::make_unique<RenderJob>(std::move(scene), settings, *current_->Canceled());
  return *current_;
}

void JobQueue::Abandon() {
  Collect();
  if (!current_) return;
  current_->Cancel();
  if (current_->Places() == 0) return abandoned_.push_back(std::move(current_));
  ForgetLast();
  last_ = std::move(current_);
}

void JobQueue::ForgetLast() {
  if (last_) abandoned_.push_back(std::move(last_));
}

int JobQueue::Collect() {
  std::erase_if(abandoned_, [](const auto& job) { return job->HasEnded(); });
  return static_cast<int>(abandoned_.size());
}

}  // namespace ray
