#pragma once

namespace ray {

/// How finely a preview is drawn. By default in full; see MotionDetail.
struct DrawingDetail {
  int pixel_step = 1;       // faces, and what is behind them, have one pixel for so many of the view, each way
  bool is_smooth = true;    // faces have several samples per pixel, where they have every pixel
  bool has_mirrors = true;  // which show the scene, not only what surrounds it
  bool is_sparse = false;   // the strongest lights alone, and FrameState::faces_in_motion
  friend bool operator==(const DrawingDetail&, const DrawingDetail&) = default;
};

}  // namespace ray
