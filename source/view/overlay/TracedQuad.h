#pragma once

#include <array>
#include <optional>
#include <utility>

#include "R3/Ray.h"
#include "source/draw/CameraMoves.h"
#include "source/render/RenderSettings.h"
#include "source/scene/Camera.h"

namespace ray {

/// The rendered image, or the crop of it that was rendered, as it hangs in space before its camera.
class TracedQuad {
 public:
  /// `own`: the camera of the scene; `middle`: of what is looked at; `radius`: of the scene.
  TracedQuad(const RenderSettings& traced, const Camera& own, const R3::Point& middle, double radius);

  const Camera& camera() const { return camera_; }
  const std::array<R3::Point, 4>& Corners() const { return corners_; }
  /// How far before the camera it is.
  double Distance() const;
  /// Whether a view of that size sees just it, whose frame would then be lines along the edges of the view.
  bool FillsView(const Camera& camera, const DrawingSize& view) const;
  /// Where a ray meets it: the parameter of the ray, and the pixel. Nothing where it misses.
  struct Meeting {
    double t;
    int column, row;
  };
  std::optional<Meeting> MeetingWith(const R3::Ray& ray) const;

 private:
  int width_, height_;     // of the whole image, in pixels
  PixelRectangle region_;  // that was rendered
  Camera camera_;
  std::array<R3::Point, 4> corners_;  // from the lower left one, counterclockwise
};

}  // namespace ray
