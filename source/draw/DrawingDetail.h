#pragma once

#include <string>

namespace ray {

/// How finely a preview is drawn. By default in full; see MotionDetail.
struct DrawingDetail {
  int pixel_step = 1;       // faces, and what is behind them, have one pixel for so many of the view, each way
  bool is_smooth = true;    // faces have several samples per pixel, where they have every pixel
  bool has_mirrors = true;  // which show the scene, not only what surrounds it
  bool is_sparse = false;   // the strongest lights alone, and FrameState::faces_in_motion
  friend bool operator==(const DrawingDetail&, const DrawingDetail&) = default;
};

/// What a user is told of it; empty where nothing is missing.
inline std::string WordsFor(const DrawingDetail& detail) {
  if (detail.is_sparse) return "moving: fewer lights and triangles";
  if (detail.pixel_step > 1 || !detail.has_mirrors) return "moving: less detail";
  return detail.is_smooth ? "" : "edges not smoothed";
}

}  // namespace ray
