#pragma once

#include <memory>
#include <optional>

#include "source/draw/FrameState.h"

namespace ray {

/// Chooses the detail of a preview: full detail when the view is at rest; while it moves, one pixel for several if a
/// drawing takes longer than a screen shows it. Edges of a view at rest are smoothed unless that delays the next event.
/// Times are seconds of any clock.
class MotionDetail {
 public:
  /// Returns the detail for the drawing of this view, begun at `now`. Even small windows keep enough pixels to
  /// recognize the scene.
  DrawingDetail For(const FrameState& shown, double now);
  /// Sets the time of the drawing for which For was called last.
  void Took(double seconds);
  /// Returns the time at which the last drawing is to be refined, unless the view moves before; std::nullopt if it has
  /// its final detail.
  std::optional<double> RefinementTime() const;

 private:
  bool IsAtRest() const { return !is_moving_; }
  /// Returns true if the next view at rest should be smoothed.
  bool IsWorthSmoothing() const;

  std::optional<ClipMatrix> view_;             // of the last drawing
  std::shared_ptr<const PreviewScene> faces_;  // of the last drawing, to which the times apply
  DrawingDetail detail_;                       // of the last drawing
  bool is_moving_ = false;                     // during the last drawing
  bool draws_faces_ = false;                   // in the last drawing; otherwise its time is meaningless
  double moved_at_ = 0;
  // Times; std::nullopt if unknown.
  std::optional<double> smooth_seconds_;  // of the last smoothed drawing
  std::optional<double> rough_seconds_;   // of the last drawing in full detail without smoothing
  // of a drawing with all pixels while the view moves, or an upper limit of it
  double motion_seconds_ = 0;
};

}  // namespace ray
