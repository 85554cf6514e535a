#include "page/PixelRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
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

/// Writes segments of space as lines of the image.
class LineWriter {
 public:
  LineWriter(const World& world, const Accelerator& accelerator, const RenderSettings& settings)
      : accelerator_(accelerator),
        camera_(CameraOf(world, settings)),
        width_(settings.width),
        height_(settings.height),
        radius_(world.scene().root.bounds.Radius()) {}

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
  std::optional<R2::Point> PlaceOf(const R3::Point& p) const { return camera_.PlaceOf(p, width_, height_); }

  /// Returns true if nothing hides a point that is seen at `place`.
  bool IsVisible(const R3::Point& p, const R2::Point& place, double time) {
    const auto sight = camera_.RayThrough(place.x, place.y, width_, height_);
    if (!sight) return false;
    R3::Ray ray{sight->origin, p - sight->origin};
    // A point on a surface is visible although rounding may put the hit a little before it. A millionth of the distance
    // is far less than a pixel.
    ray.t_max = 1 - 1e-6;
    ray.time = time;
    return !accelerator_.IsOccluded(ray, workspace_);
  }

  /// Returns the share of the way at which a piece begins, so that pieces of a perspective image are of equal length:
  /// depths are inverse linear in the image.
  static double ShareAt(int piece, double from_depth, double to_depth) {
    const double s = static_cast<double>(piece) / pieces_a_segment;
    return s * from_depth / ((1 - s) * to_depth + s * from_depth);
  }

  /// Writes a segment, without the part behind a pinhole.
  void Add(R3::Point from, R3::Point to, double time, int look) {
    double a = 1, b = 1;  // depths
    if (camera_.IsPinhole()) {
      a = Dot(from - camera_.eye, camera_.towards), b = Dot(to - camera_.eye, camera_.towards);
      const double nearest = std::max(a, b) / 1024;  // nearer points are at the edge of the image, or outside
      if (!(nearest > 0)) return;
      if (a < nearest) from = from + (nearest - a) / (b - a) * (to - from), a = nearest;
      if (b < nearest) to = to + (nearest - b) / (a - b) * (from - to), b = nearest;
    }
    const auto at = [&](int piece) { return from + ShareAt(piece, a, b) * (to - from); };
    std::optional<R2::Point> begin = PlaceOf(from);
    for (int piece = 0; piece < pieces_a_segment; ++piece) {
      const std::optional<R2::Point> end = PlaceOf(at(piece + 1));
      const R3::Point middle = at(piece) + 0.5 * (at(piece + 1) - at(piece));
      const std::optional<R2::Point> place = PlaceOf(middle);
      if (begin && end && place && !IsTorn(*begin, *end, middle))
        Write(*begin, *end, look + !IsVisible(middle, *place, time));
      begin = end;
    }
  }

  /// Returns true for a piece that leaves a panorama at one side and enters it at the other: the middle of its line in
  /// the image then looks away from the middle of the piece.
  bool IsTorn(const R2::Point& from, const R2::Point& to, const R3::Point& middle) const {
    const auto sight = camera_.RayThrough((from.x + to.x) / 2, (from.y + to.y) / 2, width_, height_);
    return !sight || !(Dot(sight->direction, middle - sight->origin) > 0);
  }

  /// Writes a line, unless it ends so far outside that floats of a browser would not keep tenths of a pixel.
  void Write(const R2::Point& from, const R2::Point& to, int look) {
    constexpr double farthest = 1e6;
    constexpr int digits = 6;
    const std::array numbers{from.x, from.y, to.x, to.y};
    if (std::ranges::any_of(numbers, [](double x) { return std::abs(x) > farthest; })) return;
    for (const double number : numbers) text_ += "," + Rounded(number, digits);
    text_ += "," + std::to_string(look);
  }

  const Accelerator& accelerator_;
  const Camera camera_;
  const int width_, height_;
  const double radius_;  // of the scene
  Workspace workspace_;
  std::string text_;
};

/// Returns the numbers of the first rays in the order of RayTree: depth first, children in the order they were traced.
std::vector<std::size_t> TreeOrder(const PixelTrace& trace, std::size_t most) {
  const auto children = trace.Children();
  std::vector<std::size_t> open, order;
  for (std::size_t i = 0; i < trace.rays.size(); ++i)
    if (trace.rays[i].parent == RecordedRay::none) open.push_back(i);
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
  for (const std::size_t i : TreeOrder(trace, most_rays_of_tree)) {
    const RecordedRay& ray = trace.rays[i];
    json += json.empty() ? "[[" : ",[";
    json += std::to_string(static_cast<int>(ray.kind)) + "," + std::to_string(ray.depth) + writer.LinesOf(ray) + "]";
  }
  return json.empty() ? "[]" : json + "]";
}

}  // namespace ray
