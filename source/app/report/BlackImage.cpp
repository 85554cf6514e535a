#include "source/app/report/BlackImage.h"

#include <algorithm>
#include <vector>

#include "source/app/Interrupt.h"
#include "source/render/Render.h"
#include "source/render/RenderInputs.h"

namespace ray {
namespace {

/// Returns the settings of a small image with the same view and light.
RenderSettings Small(const RenderSettings& settings) {
  constexpr int side = 32;
  RenderSettings small = settings;
  const int longest = std::max(settings.width, settings.height);
  const auto scaled = [&](int pixels) {
    return longest <= side ? pixels : std::max(1, static_cast<int>(std::int64_t{pixels} * side / longest));
  };
  small.width = scaled(settings.width), small.height = scaled(settings.height);
  small.samples = 1;
  small.places = BlockOrder::places;
  small.budget = {};
  small.crop.reset(), small.part.reset(), small.replay.reset();
  small.denoise = small.wants_passes = false;
  small.flare = 0;
  return small;
}

/// A summary of the hits of the camera rays of a small image.
struct Views {
  std::size_t backs = 0;            // hits on the back of a surface
  std::size_t black = 0;            // hits on a surface that reflects nothing
  std::vector<double> distances;    // of all hits, along the viewing direction
  bool meets_removed_back = false;  // a ray would hit a one-sided surface from behind
};

/// Returns true if the ray hits the invisible back of a one-sided surface.
bool MeetsRemovedBack(const World& world, const R3::Ray& ray) {
  return std::ranges::any_of(world.Instances(), [&](const Instance& instance) {
    if (!instance.material->one_sided) return false;
    const R3::Shape& two_sided = instance.mesh ? *instance.mesh : *instance.node->shape;
    const R3::Ray local = world.Back(instance.frame, ray);
    for (int i = 0; i < two_sided.Elements(); ++i)
      if (two_sided.Intersect(local, i)) return true;
    return false;
  });
}

Views ViewsOf(const World& world, const Accelerator& accelerator, const RenderSettings& small, const Camera& camera) {
  constexpr std::size_t most_tried = 16;  // rays, since all instances are tested
  Views views;
  Workspace workspace;
  const auto pixels = static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height);
  std::size_t missed = 0;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const auto ray = camera.RayThrough(x + 0.5, y + 0.5, small.width, small.height);
      if (!ray) continue;
      const auto hit = accelerator.Intersect(*ray, workspace);
      if (!hit) {
        if (missed++ % std::max<std::size_t>(1, pixels / most_tried) == 0)
          views.meets_removed_back = views.meets_removed_back || MeetsRemovedBack(world, *ray);
        continue;
      }
      const R3::Intersection at = world.At(*ray, *hit);
      const Material& m = world.MaterialAt(*hit);
      views.distances.push_back(Dot(at.position - camera.eye, camera.towards));
      views.backs += Dot(at.normal, ray->direction) > 0;
      views.black += IsBlack(m.kd) && IsBlack(m.ks) && IsBlack(m.kr) && IsBlack(m.kt);
    }
  return views;
}

bool IsLitWith(const World& world, const Accelerator& accelerator, const RenderSettings& settings) {
  RenderMonitor monitor;
  monitor.stop = StopRequested();
  return !IsWhollyBlack(Render(world, accelerator, settings, monitor).image);
}

/// Returns the settings with the eye behind the first surface that most rays meet.
RenderSettings BehindFirstSurface(const RenderSettings& small, Camera camera, std::vector<double> distances) {
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  constexpr double beyond = 1.01;
  camera.eye = camera.eye + beyond * *middle * camera.towards;
  RenderSettings moved = small;
  moved.view = camera;
  return moved;
}

}  // namespace

bool IsWhollyBlack(const R2::Image& image) {
  return std::ranges::all_of(image.Channels(), [](float channel) { return channel == 0; });
}

std::string WhyBlack(const World& world, const Accelerator& accelerator, const RenderSettings& settings) {
  const RenderSettings small = Small(settings);
  const Camera camera = CameraOf(world, settings);
  const Views views = ViewsOf(world, accelerator, small, camera);
  if (views.distances.empty())
    return views.meets_removed_back ? "all surfaces in view are one-sided and turned away from the camera"
                                    : "the camera sees nothing but the background, which is black";
  if (views.black == views.distances.size()) return "every surface in view is black: its kd, ks, kr and kt are 0";
  if (IsLitWith(world, accelerator, BehindFirstSurface(small, camera, views.distances)))
    return "there is light only behind the surfaces that the camera sees; it may be outside of a closed room";
  RenderSettings without_shadows = small;
  without_shadows.trace.shadows = false;
  if (small.trace.shadows && IsLitWith(world, accelerator, without_shadows))
    return "everything in view is in shadow: no light reaches it";
  if (2 * views.backs > views.distances.size())
    return "the camera sees surfaces from behind, and the lights are on their other side";
  return "no light reaches the surfaces in view";
}

}  // namespace ray
