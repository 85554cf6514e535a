#include "source/draw/MotionDetail.h"

#include <algorithm>
#include <cmath>

namespace ray {
namespace {

constexpr double seconds_of_frame = 1.0 / 60;  // on a usual screen
constexpr double seconds_of_rest = 0.15;       // a hand that pauses for longer has stopped
constexpr double seconds_of_patience = 1;      // maximum delay of the next event by a smoothed drawing
constexpr double smoothing_takes = 5;          // times a drawing without smoothing; measured after the first
constexpr int least_pixels = 240;              // across; the width of the smallest old screens

/// Returns the pixel step in motion: the time of a drawing is proportional to its number of pixels.
int StepInMotion(double seconds, const DrawingSize& size) {
  const int most = std::max(1, std::min(size.width, size.height) / least_pixels);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(seconds / seconds_of_frame))), 1, most);
}

}  // namespace

DrawingDetail MotionDetail::For(const FrameState& shown, double now) {
  if (shown.faces != faces_) smooth_seconds_.reset(), rough_seconds_.reset();
  faces_ = shown.faces;
  const bool has_moved = view_ && *view_ != shown.clip_from_drawing;
  if (has_moved) moved_at_ = now;
  is_moving_ = has_moved || (is_moving_ && now < moved_at_ + seconds_of_rest);
  view_ = shown.clip_from_drawing;
  draws_faces_ = shown.shows_faces && !shown.covering;
  if (is_moving_) {
    const bool is_quick = smooth_seconds_ && std::max(*smooth_seconds_, motion_seconds_) < seconds_of_frame / 2;
    detail_ = {StepInMotion(motion_seconds_, shown.view), is_quick};
  } else {
    detail_ = {1, IsWorthSmoothing()};
  }
  return detail_;
}

bool MotionDetail::IsWorthSmoothing() const {
  if (smooth_seconds_) return *smooth_seconds_ < seconds_of_patience;
  return rough_seconds_ && smoothing_takes * *rough_seconds_ < seconds_of_patience;
}

void MotionDetail::Took(double seconds) {
  if (!draws_faces_) return;
  if (IsAtRest()) (detail_.is_smooth ? smooth_seconds_ : rough_seconds_) = seconds;
  // An upper limit of the time with all pixels, since a part of a drawing's time does not depend on them.
  const int step = detail_.pixel_step;
  const double bound = step * step * seconds;
  motion_seconds_ = step == 1 ? bound : std::min(motion_seconds_, bound);
}

std::optional<double> MotionDetail::RefinementTime() const {
  if (detail_ == DrawingDetail{}) return {};
  if (!IsAtRest()) return moved_at_ + seconds_of_rest;
  if (IsWorthSmoothing()) return moved_at_;
  return {};
}

}  // namespace ray
