#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "source/view/live/AcceleratorCost.h"

namespace ray {

/// The comparison of accelerators that was begun last, and those of scenes from before that have yet to end.
class AcceleratorComparisons {
 public:
  void Begin(std::shared_ptr<const LoadedScene> scene, const AcceleratorSettings& how, const RenderSettings& settings) {
    Forget();
    current_ = std::make_unique<AcceleratorComparison>(std::move(scene), how, settings);
    seen_ = 0;
  }
  void Stop() {
    if (current_) current_->Stop();
  }
  /// Another scene is shown.
  void Forget() {
    Stop();
    if (current_) ending_.push_back(std::move(current_));
  }

  /// Null before the first, and for another scene.
  const AcceleratorComparison* Current() const { return current_.get(); }
  bool IsBusy() const { return current_ && !current_->HasEnded(); }
  /// Whether it has found more since the last call; to be called now and then.
  bool HasNews() {
    std::erase_if(ending_, [](const auto& comparison) { return comparison->HasEnded(); });
    const int seen = seen_;
    if (current_) seen_ = current_->Version();
    return seen_ != seen;
  }

 private:
  std::unique_ptr<AcceleratorComparison> current_;
  std::vector<std::unique_ptr<AcceleratorComparison>> ending_;
  int seen_ = 0;  // version of the current one
};

}  // namespace ray
