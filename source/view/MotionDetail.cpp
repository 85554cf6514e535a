#include "source/view/MotionDetail.h"

#include <algorithm>
#include <cmath>

namespace ray {
namespace {

constexpr double seconds_of_frame = 1.0 / 60;  // of a usual screen
constexpr double seconds_of_rest = 0.15;       // a hand that pauses for longer has stopped
constexpr int least_pixels = 240;              // across, which the smallest screens once had

/// What a drawing takes falls with the number of its pixels.
int StepInMotion(double full_seconds, const DrawingSize& size) {
  const int most = std::max(1, std::min(size.width, size.height) / least_pixels);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(full_seconds / seconds_of_frame))), 1, most);
}

}  // namespace

int MotionDetail::StepFor(const ClipMatrix& view, const DrawingSize& size, double now) {
  const bool has_moved = view_ && *view_ != view;
  if (has_moved) moved_at_ = now;
  const auto refinement = RefinementTime();
  const bool moves = has_moved || (refinement && now < *refinement);
  step_ = moves ? StepInMotion(full_seconds_, size) : 1;
  is_smooth_ = !moves || full_seconds_ < seconds_of_frame / 2;
  view_ = view;
  return step_;
}

void MotionDetail::Took(double seconds) {
  // In full it would have taken at most so long: not all that a drawing takes is for pixels.
  const double bound = step_ * step_ * seconds;
  full_seconds_ = step_ == 1 ? bound : std::min(full_seconds_, bound);
}

std::optional<double> MotionDetail::RefinementTime() const {
  if (step_ == 1 && is_smooth_) return {};
  return moved_at_ + seconds_of_rest;
}

}  // namespace ray
