#include "page/PixelRays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "R1/Elementary.h"
#include "source/integrate/RayCounts.h"
#include "source/render/RenderInputs.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr int pieces_a_segment = 32;      // visible or hidden as a whole
constexpr double ray_to_nowhere = 2;      // radii of the scene
constexpr double beyond_a_blocker = 0.2;  // likewise, towards a light at infinity

using R1::Hypot;

/// A point in the image, and its distance along the axis of the camera.
struct ImagePoint {
  double x = 0, y = 0, depth = 0;
};

/// Maps points of the world to points of the image.
class Projector {
 public:
  Projector(const Camera& camera, int width, int height)
      : camera_(camera), name_(camera.kind->name), width_(width), height_(height) {
    const double aspect = camera.kind->aspect > 0 ? camera.kind->aspect : camera.aspect;
    half_height_ = aspect > 0 ? 1 / aspect : static_cast<double>(height) / width;
  }

  bool IsPinhole() const { return camera_.IsPinhole(); }
  bool IsOrthographic() const { return name_ == "orthographic"; }

  double Depth(const R3::Point& p) const { return Dot(p - camera_.eye, camera_.towards); }

  /// Returns std::nullopt if the projection is unknown, and behind a pinhole.
  std::optional<ImagePoint> operator()(const R3::Point& p) const {
    const R3::Vector d = p - camera_.eye;
    const double right = Dot(d, camera_.right), up = Dot(d, camera_.up), depth = Depth(p);
    const auto place = PlaceOf(right, up, depth);
    if (!place) return {};
    const R2::Vector& shift = camera_.shift;
    const ImagePoint at{width_ * (place->x - shift.x + 1) / 2, height_ * ((place->y - shift.y) / half_height_ + 1) / 2,
                        depth};
    if (!(std::abs(at.x) + std::abs(at.y) < farthest)) return {};
    return at;
  }

  /// Returns the ray from the eye that ends at `p`, at t = 1.
  R3::Ray SightTo(const R3::Point& p, double time) const {
    const R3::Vector line = IsOrthographic() ? Depth(p) * camera_.towards : p - camera_.eye;
    R3::Ray ray{p - line, line};
    // A point on a surface is visible although rounding may put the hit a little before it. A millionth of the distance
    // is far less than a pixel.
    ray.t_max = 1 - 1e-6;
    ray.time = time;
    return ray;
  }

 private:
  static constexpr double farthest = 1e6;  // pixels from the corner, so that floats of a browser keep tenths of one

  /// Returns the place in half widths from the axis: the inverse of CameraKind::sight.
  std::optional<R2::Vector> PlaceOf(double right, double up, double depth) const {
    const double half_degrees = camera_.Extent() / 2, degree = std::numbers::pi / 180;
    if (IsOrthographic()) return R2::Vector{right / half_degrees, up / half_degrees};  // half the width
    if (IsPinhole()) {
      const double half = camera_.HalfWidth();
      if (!(depth > 0)) return {};
      return R2::Vector{right / depth / half, up / depth / half};
    }
    const double angle = R1::Atan2(right, depth), level = Hypot(right, depth), aside = Hypot(right, up);
    if (name_ == "cylinder") return R2::Vector{angle / degree / half_degrees, up / level / degree / half_degrees};
    if (name_ == "latlong") return R2::Vector{angle / std::numbers::pi, R1::Atan2(up, level) / std::numbers::pi};
    if (name_ != "fisheye") return {};
    const double from_axis = R1::Atan2(aside, depth) / degree / half_degrees;
    return aside > 0 ? R2::Vector{from_axis * right / aside, from_axis * up / aside} : R2::Vector{from_axis, 0};
  }

  const Camera camera_;
  const std::string_view name_;
  const int width_, height_;
  double half_height_;  // of the image, in half widths
};

/// Writes segments of space as lines of the image.
class LineWriter {
 public:
  LineWriter(const World& world, const Accelerator& accelerator, const RenderSettings& settings)
      : accelerator_(accelerator),
        projector_(CameraOf(world, settings), settings.width, settings.height),
        radius_(std::max(world.scene().root.bounds.Radius(), 1e-300)) {}

  std::string LinesOf(const RecordedRay& ray) {
    text_.clear();
    const R3::Point start = ray.ray.At(std::max(0.0, ray.ray.t_min));
    const R3::Vector along = radius_ * Unit(ray.ray.direction);
    const R3::Point end = ray.End().value_or(start + ray_to_nowhere * along);
    Add(start, end, ray.ray.time, 0);
    if (ray.kind == RayKind::shadow && ray.at)
      Add(end, ray.ray.t_max < R3::infinity ? ray.ray.At(1) : end + beyond_a_blocker * along, ray.ray.time, 2);
    return std::move(text_);
  }

 private:
  /// Returns the share of the way from `from` at which a piece begins, so that pieces of a perspective image are of
  /// equal length: depths are inverse linear in the image.
  static double ShareAt(int piece, double from_depth, double to_depth) {
    const double s = static_cast<double>(piece) / pieces_a_segment;
    return from_depth > 0 && to_depth > 0 ? s * from_depth / ((1 - s) * to_depth + s * from_depth) : s;
  }

  /// Writes a segment, without what is behind a pinhole.
  void Add(R3::Point from, R3::Point to, double time, int look) {
    double a = projector_.Depth(from), b = projector_.Depth(to);
    if (projector_.IsPinhole()) {
      const double nearest = std::max(a, b) / 1024;  // what is nearer is at the edge of the image, or outside
      if (!(nearest > 0)) return;
      if (a < nearest) from = from + (nearest - a) / (b - a) * (to - from), a = nearest;
      if (b < nearest) to = to + (nearest - b) / (a - b) * (from - to), b = nearest;
    } else if (projector_.IsOrthographic()) {
      a = b = 1;
    }
    const auto at = [&](int piece) { return from + ShareAt(piece, a, b) * (to - from); };
    std::optional<ImagePoint> begin = projector_(from);
    for (int piece = 0; piece < pieces_a_segment; ++piece) {
      const std::optional<ImagePoint> end = projector_(at(piece + 1));
      const R3::Point middle = at(piece) + 0.5 * (at(piece + 1) - at(piece));
      if (begin && end && !IsTorn(*begin, *end))
        Write(*begin, *end, look + accelerator_.IsOccluded(projector_.SightTo(middle, time), workspace_));
      begin = end;
    }
  }

  /// Returns true for a piece that leaves a panorama at one side and enters it at the other.
  bool IsTorn(const ImagePoint& from, const ImagePoint& to) const {
    return !projector_.IsPinhole() && !projector_.IsOrthographic() &&
           Hypot(from.x - to.x, from.y - to.y) > most_pixels_a_piece;
  }

  void Write(const ImagePoint& from, const ImagePoint& to, int look) {
    constexpr int digits = 6;
    for (const double number : {from.x, from.y, to.x, to.y}) text_ += "," + Rounded(number, digits);
    text_ += "," + std::to_string(look);
  }

  static constexpr double most_pixels_a_piece = 200;

  const Accelerator& accelerator_;
  const Projector projector_;
  const double radius_;
  Workspace workspace_;
  std::string text_;
};

/// Returns the numbers of the first rays in the order of RayTree: depth first, children in the order they were traced.
std::vector<std::size_t> TreeOrder(const std::vector<RecordedRay>& rays, std::size_t most) {
  std::vector<std::vector<std::size_t>> children(rays.size());
  std::vector<std::size_t> open, order;
  for (std::size_t i = 0; i < rays.size(); ++i)
    (rays[i].parent == RecordedRay::none ? open : children[static_cast<std::size_t>(rays[i].parent)]).push_back(i);
  std::ranges::reverse(open);
  while (!open.empty() && order.size() < most) {
    const std::size_t i = open.back();
    open.pop_back();
    order.push_back(i);
    open.insert(open.end(), children[i].rbegin(), children[i].rend());
  }
  return order;
}

}  // namespace

std::string RaysInImage(const PixelTrace& trace, const World& world, const Accelerator& accelerator,
                        const RenderSettings& settings) {
  LineWriter writer(world, accelerator, settings);
  std::string json;
  for (const std::size_t i : TreeOrder(trace.rays, most_rays_of_tree)) {
    const RecordedRay& ray = trace.rays[i];
    json += json.empty() ? "[[" : ",[";
    json += std::to_string(static_cast<int>(ray.kind)) + "," + std::to_string(ray.depth) + writer.LinesOf(ray) + "]";
  }
  return json.empty() ? "[]" : json + "]";
}

}  // namespace ray
