#include "page/PixelRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "R1/Elementary.h"
#include "source/inspect/ImageLines.h"
#include "source/integrate/RayCounts.h"
#include "source/render/RenderInputs.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double ray_to_nowhere = 2;      // radii of the scene
constexpr double beyond_a_blocker = 0.2;  // likewise, towards a light at infinity

/// Writes segments of space as lines of the image.
class LineWriter {
 public:
  LineWriter(const World& world, const Accelerator& accelerator, const RenderSettings& settings)
      : accelerator_(accelerator),
        lines_(CameraOf(world, settings), settings.width, settings.height,
               [this](const R3::Point& p, const R3::Ray& sight, const R2::Point&) { return IsVisible(p, sight); }),
        radius_(world.scene().root.bounds.Radius()) {}

  std::string LinesOf(const RecordedRay& ray) {
    text_.clear();
    time_ = ray.ray.time;
    const R3::Point start = ray.ray.At(std::max(0.0, ray.ray.t_min));
    const R3::Vector along = radius_ * Unit(ray.ray.direction);
    const R3::Point end = ray.End().value_or(start + ray_to_nowhere * along);
    Add(start, end, 0);
    if (ray.kind == RayKind::shadow && ray.at)
      Add(end, ray.ray.t_max < R3::infinity ? ray.ray.At(1) : end + beyond_a_blocker * along, 2);
    return std::move(text_);
  }

 private:
  /// Returns true if nothing hides a point.
  bool IsVisible(const R3::Point& p, const R3::Ray& sight) {
    R3::Ray ray{sight.origin, p - sight.origin};
    // A point on a surface is visible although rounding may put the hit a little before it. A millionth of the distance
    // is far less than a pixel.
    ray.t_max = 1 - 1e-6;
    ray.time = time_;
    return !accelerator_.IsOccluded(ray, workspace_);
  }

  void Add(const R3::Point& from, const R3::Point& to, int look) {
    for (const ImageLine& line : lines_.Of(from, to)) Write(line.from, line.to, look + line.is_hidden);
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
  const ImageLines lines_;
  const double radius_;  // of the scene
  double time_ = 0;      // of the ray being written
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
