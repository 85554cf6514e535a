#pragma once

#include <optional>

#include "source/inspect/DebugRays.h"
#include "source/inspect/LoadedScene.h"
#include "source/inspect/SliceView.h"

namespace ray {

/// A cross section of the scene by a plane that the user moves, with the rays of the pixels near it.
class SectionView {
 public:
  bool IsShown() const { return is_shown_; }
  void Toggle() { is_shown_ = !is_shown_; }
  /// The next of camera_row, xz, yz, xy.
  void NextPlane();
  /// Shows that row of an image, if camera_row is shown. Returns true if the row has changed.
  bool MoveTo(int row);
  /// Moves a row up or down in an image of that height, or by a hundredth of the scene along the plane's normal.
  void Move(int by, int height);
  /// Cuts the scene again, for a drawing of that size; for camera_row with the camera of `settings`, for other planes
  /// through `center` of the scene. Rays are those of the row, or of the middle row (of the middle column for yz).
  void Cut(const LoadedScene& scene, const RenderSettings& settings, const R3::Point& center, const DrawingSize& size,
           const DebugRayCounts& counts = {});

  SlicePlane Plane() const { return plane_; }
  /// The image row of camera_row, from the bottom.
  int Row(int height) const { return row_ < 0 ? height / 2 : std::min(row_, height - 1); }
  /// Once it was cut.
  const std::optional<SceneCut>& cut() const { return cut_; }
  /// The rays of every n-th pixel, traced with the cut.
  const std::vector<PixelTrace>& Rays() const { return rays_; }
  /// All of it, in the square from -1 to 1, and labels in pixels from its lower left corner. Once it was cut.
  ///   line_width   of lines, in pixels
  SliceAxes Drawing(const LoadedScene& scene, const RayLook& look, const LetterSize& letters, int line_width = 1) const;
  /// Describes the place of a pixel of the drawing, its distance from the eye (camera_row) or the origin of the plane's
  /// axes, and how far from another pixel. Once it was cut.
  std::string DescribePlace(const R2::Point& pixel, const std::optional<R2::Point>& from) const;
  std::string Describe(int height) const;

 private:
  /// The camera in the coordinates of the slice: the eye, and the ends of a row or column in an image before it.
  struct CameraMark {
    R2::Point eye, left, right;
  };
  /// A row or a column of an image.
  struct PixelLine {
    bool is_column = false;
    int at = 0;
  };
  void TraceLine(const LoadedScene& scene, const RenderSettings& settings, const PixelLine& line,
                 const DebugRayCounts& counts);
  static CameraMark MarkOf(const Camera& camera, const PixelLine& line, const RenderSettings& settings,
                           const Slice& slice, double scene_radius);
  void AddNormals(Lines& lines) const;
  void AddRays(Lines& lines, const RayLook& look) const;
  void AddMark(Lines& lines, double radius) const;

  bool is_shown_ = false;
  SlicePlane plane_ = SlicePlane::camera_row;
  int row_ = -1;       // -1: the middle row
  double offset_ = 0;  // of the other planes, in radii of the scene
  std::optional<SceneCut> cut_;
  SliceView view_;
  SliceCoordinates coordinates_;
  std::vector<PixelTrace> rays_;
  std::optional<CameraMark> mark_;
};

}  // namespace ray
