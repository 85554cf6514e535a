#pragma once

#include <optional>

#include "source/view/Drawing.h"
#include "source/view/camera/CameraMoves.h"

namespace ray {

/// How finely a preview is drawn: in full where the view rests; while it moves, one pixel for several where a drawing
/// in full takes longer than a screen shows it. Times are seconds of any clock.
class MotionDetail {
 public:
  /// How many pixels of the screen, each way, one of the drawing of this view is to fill, begun `now`; at least 1, and
  /// so few that a small window is still told apart.
  int StepFor(const ClipMatrix& view, const DrawingSize& size, double now);
  /// Whether the drawing of StepFor is worth several samples per pixel: the view rests, or they take no time.
  bool IsSmooth() const { return is_smooth_; }
  /// How long the drawing took for which StepFor was asked last.
  void Took(double seconds);
  /// When the last drawing is to be drawn again in full, unless the view moves before; nothing where it was in full.
  std::optional<double> RefinementTime() const;

 private:
  std::optional<ClipMatrix> view_;  // drawn last
  int step_ = 1;                    // of that
  bool is_smooth_ = true;           // likewise
  double moved_at_ = 0;
  double full_seconds_ = 0;  // that a drawing in full takes, or a bound of it; 0: not known yet
};

}  // namespace ray
