#pragma once

#include <memory>
#include <optional>

#include "source/draw/FrameState.h"

namespace ray {

/// How finely a preview is drawn: in full where the view rests; while it moves, one pixel for several where a drawing
/// takes longer than a screen shows it. Edges of a view at rest are smoothed where that keeps nobody waiting. Times are
/// seconds of any clock.
class MotionDetail {
 public:
  /// The detail for the drawing of this view, begun `now`. Pixels are never so few that a small window is not told
  /// apart.
  DrawingDetail For(const FrameState& shown, double now);
  /// How long the drawing took for which For was asked last.
  void Took(double seconds);
  /// When the last drawing is to be drawn again more finely, unless the view moves before; nothing where it was as fine
  /// as it will be.
  std::optional<double> RefinementTime() const;

 private:
  bool IsAtRest() const { return !is_moving_; }
  /// Whether to smooth a view at rest that is drawn next.
  bool IsWorthSmoothing() const;

  std::optional<ClipMatrix> view_;             // drawn last
  std::shared_ptr<const PreviewScene> faces_;  // drawn last; times are theirs
  DrawingDetail detail_;                       // of the last drawing
  bool is_moving_ = false;                     // likewise
  bool draws_faces_ = false;                   // likewise; else its time says nothing
  double moved_at_ = 0;
  // Nothing where it is not known.
  std::optional<double> smooth_seconds_;  // that the last smoothed drawing took
  std::optional<double> rough_seconds_;   // that the last drawing took that was in full but for that
  double motion_seconds_ = 0;             // that one in all pixels would take while the view moves, or a bound of it
};

}  // namespace ray
