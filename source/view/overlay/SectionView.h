#pragma once

#include <memory>
#include <optional>

#include "source/view/LoadedScene.h"
#include "source/view/overlay/CrossSection.h"
#include "source/view/overlay/DebugRays.h"

namespace ray {

/// A cross section of the scene by a plane that the user moves, with the rays of the pixels near it.
class SectionView {
 public:
  bool IsShown() const { return is_shown_; }
  void Toggle() { is_shown_ = !is_shown_; }
  /// The next of camera_row, xz, yz, xy.
  void NextPlane();
  /// A row up or down, or a hundredth of the scene along the plane's normal.
  void Move(int by);
  /// Cuts the scene again; for camera_row as seen by `settings`, for others through `center` of the scene.
  void Cut(const LoadedScene& scene, const RenderSettings& settings, const R3::Point& center);

  SlicePlane Plane() const { return plane_; }
  /// The row of the picture that camera_row is, from the bottom.
  int Row(int height) const { return row_ < 0 ? height / 2 : std::min(row_, height - 1); }
  /// Once it was cut.
  const std::optional<SceneCut>& cut() const { return cut_; }
  /// The rays of every so many pixels of the row (camera_row), traced with the cut.
  const std::vector<PixelTrace>& Rays() const { return rays_; }
  /// All of it, in the square from -1 to 1.
  Lines Drawing(const LoadedScene& scene, const RayLook& look) const;
  std::string Describe(int height) const;

 private:
  bool is_shown_ = false;
  SlicePlane plane_ = SlicePlane::camera_row;
  int row_ = -1;         // the middle until it is moved
  int last_height_ = 1;  // of the picture when it was last cut
  double offset_ = 0;    // of the other planes, in radii of the scene
  std::optional<SceneCut> cut_;
  std::vector<PixelTrace> rays_;
};

}  // namespace ray
