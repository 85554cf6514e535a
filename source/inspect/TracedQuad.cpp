#include "source/inspect/TracedQuad.h"

#include "source/scene/CameraText.h"

namespace ray {
namespace {

constexpr double share_of_distance = 0.25;  // how far it hangs before its camera, of the way to the middle

}  // namespace

TracedQuad::TracedQuad(const RenderSettings& traced, const Camera& own, const R3::Point& middle, double radius)
    : width_(traced.width), height_(traced.height), region_(RegionOf(traced)), camera_(traced.view.value_or(own)) {
  const double to_middle = DepthOf(camera_, middle);
  const double distance = share_of_distance * (to_middle > 0 ? to_middle : radius);
  const auto corner = [&](double x, double y) { return camera_.Through(x, y, width_, height_).At(distance); };
  const double left = region_.x0, bottom = region_.y0, right = region_.x1, top = region_.y1;
  corners_ = {corner(left, bottom), corner(right, bottom), corner(right, top), corner(left, top)};
}

double TracedQuad::Distance() const {
  return Length(corners_[0] - camera_.eye) > 0 ? DepthOf(camera_, corners_[0]) : 0;
}

bool TracedQuad::FillsView(const Camera& camera, const DrawingSize& view) const {
  const bool is_whole = region_ == PixelRectangle{0, 0, width_, height_};
  return is_whole && CameraLine(camera_) == CameraLine(camera) &&
         std::int64_t{width_} * view.height == std::int64_t{height_} * view.width;
}

std::optional<TracedQuad::Meeting> TracedQuad::MeetingWith(const R3::Ray& ray) const {
  const R3::Vector across = corners_[1] - corners_[0], upward = corners_[3] - corners_[0],
                   normal = Cross(across, upward);
  const double t = Dot(corners_[0] - ray.origin, normal) / Dot(ray.direction, normal);
  if (!(t > 0)) return {};
  const R3::Vector way = ray.At(t) - corners_[0];
  const double x = Dot(way, across) / Dot(across, across) * region_.Width();
  const double y = Dot(way, upward) / Dot(upward, upward) * region_.Height();
  if (!(x >= 0 && y >= 0 && x < region_.Width() && y < region_.Height())) return {};
  return Meeting{t, region_.x0 + static_cast<int>(x), region_.y0 + static_cast<int>(y)};
}

}  // namespace ray
