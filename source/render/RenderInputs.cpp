#include "source/render/RenderInputs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

#include "source/integrate/SharedPaths.h"
#include "source/render/Schedule.h"

namespace ray {

Camera CameraOf(const World& world, const RenderSettings& settings) {
  return settings.view.value_or(world.scene().camera);
}

namespace {

/// Returns the distances of the nearest and the farthest surface seen through the centers of the whole image's pixels.
ZBufferRange RangeOfImage(const World& world, const Accelerator& accelerator, const RenderSettings& settings) {
  const Camera camera = CameraOf(world, settings);
  const auto range_of_row = [&](int row, ZBufferRange so_far) {
    Workspace workspace;
    for (int column = 0; column < settings.width; ++column) {
      const auto ray = camera.RayThrough(column + 0.5, row + 0.5, settings.width, settings.height);
      const auto hit = ray ? accelerator.Intersect(*ray, workspace) : std::nullopt;
      if (!hit) continue;
      const double distance = hit->t * Length(ray->direction);
      so_far = {std::min(so_far.near, distance), std::max(so_far.far, distance)};
    }
    return so_far;
  };
  const ZBufferRange range = tbb::parallel_reduce(
      tbb::blocked_range(0, settings.height), ZBufferRange{R3::infinity, 0},
      [&](const tbb::blocked_range<int>& rows, ZBufferRange so_far) {
        for (int row = rows.begin(); row != rows.end(); ++row) so_far = range_of_row(row, so_far);
        return so_far;
      },
      [](const ZBufferRange& a, const ZBufferRange& b) {
        return ZBufferRange{std::min(a.near, b.near), std::max(a.far, b.far)};
      });
  return range.far > 0 ? range : ZBufferRange{0, 1};
}

}  // namespace

std::unique_ptr<const Integrator> IntegratorOf(const World& world, const Accelerator& accelerator,
                                               const RenderSettings& settings) {
  TraceSettings trace = TraceSettingsOf(settings);
  const Camera camera = CameraOf(world, settings);
  trace.outline.right = 2 * camera.HalfWidth() / settings.width * camera.right;
  trace.outline.up = 2 * camera.HalfHeight(settings.width, settings.height) / settings.height * camera.up;
  trace.outline.camera = camera;
  trace.outline.image_width = settings.width, trace.outline.image_height = settings.height;
  if (settings.mode == RenderMode::zbuffer && trace.zbuffer.IsOfImage())
    trace.zbuffer = RangeOfImage(world, accelerator, settings);
  return MakeIntegrator(settings.mode, world, accelerator, trace);
}

TraceSettings TraceSettingsOf(const RenderSettings& settings) {
  TraceSettings trace = settings.trace;
  trace.samples = PlannedSamples(settings);
  return trace;
}

CameraRays CameraRaysOf(const World& world, const RenderSettings& settings) {
  return CameraRaysOf(world, settings, PlannedSamples(settings));
}

CameraRays CameraRaysOf(const World& world, const RenderSettings& settings, std::uint32_t samples) {
  return CameraRays(CameraOf(world, settings), settings.camera, world.Moves(), settings.width, settings.height,
                    settings.trace.sampler, samples);
}

Film EmptyFilmOf(const RenderSettings& settings) {
  return Film(settings.width, settings.height, RegionOf(settings), settings.filter, SurroundingsOf(settings),
              settings.shares_light ? SharedPaths::side / Film::block_side : 1);
}

double ExpectedRays(const RenderSettings& settings) {
  constexpr double rays_per_camera_ray = 3;  // with shadows and reflections, in scenes of the course
  constexpr double rays_per_second = 1e6;
  if (settings.budget.seconds > 0) return rays_per_second * settings.budget.seconds;
  const int parts = settings.part ? settings.part->of : 1;
  const double share = IsSubsampled(settings) ? static_cast<double>(settings.places) / BlockOrder::places : 1;
  return rays_per_camera_ray * share * static_cast<double>(MadeRegionOf(settings).Area()) * settings.samples / parts;
}

}  // namespace ray
