#pragma once

#include <array>
#include <optional>

#include "R3/Ray.h"
#include "source/draw/CameraMoves.h"
#include "source/render/RenderSettings.h"
#include "source/scene/Camera.h"

namespace ray {

/// The rendered image, or its crop, in space before its camera.
class TracedQuad {
 public:
  /// `own`: the camera of the scene; `middle`: of the objects in view; `radius`: of the scene.
  TracedQuad(const RenderSettings& traced, const Camera& own, const R3::Point& middle, double radius);

  const Camera& camera() const { return camera_; }
  const std::array<R3::Point, 4>& Corners() const { return corners_; }
  /// Returns its distance from the camera.
  double Distance() const;
  /// Returns true if it fills a view of that size exactly, so that its frame would run along the edges of the view.
  bool FillsView(const Camera& camera, const DrawingSize& view) const;
  /// Returns the intersection with a ray: the parameter of the ray, and the pixel; std::nullopt if it misses.
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
