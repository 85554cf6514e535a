#include "source/render/FirstLook.h"

#include <utility>

namespace ray {

PassTargets LookTargets(std::size_t blocks, int places) {
  return {std::vector<std::uint32_t>(blocks, 0), std::vector<std::uint8_t>(blocks, static_cast<std::uint8_t>(places))};
}

int PlacesWithin(double seconds, std::int64_t pixels, double pixels_per_second) {
  const double most = seconds * pixels_per_second * BlockOrder::places / static_cast<double>(pixels);
  int places = 1;
  while (places < BlockOrder::places && 4 * places <= most) places *= 4;
  return places;
}

FirstLook::FirstLook(const World& world, const Integrator& integrator, const RenderSettings& settings,
                     const std::atomic<bool>* stop, const std::function<void(std::uint64_t rays)>& count)
    : settings_(settings),
      camera_(CameraRaysOf(world, settings)),
      source_{integrator, camera_, RandomKey(settings.seed), settings.clamp == Clamp::samples},
      film_(EmptyFilmOf(settings)),
      runner_({source_, film_, false, settings.threads, settings.tile_size, stop,
               [count](std::int64_t, const RayCounts& rays) { count(rays.Total()); }}) {}

PassRunner::End FirstLook::Look(int places, std::chrono::steady_clock::time_point pause_at) {
  targets_ = LookTargets(static_cast<std::size_t>(film_.Blocks()), places);
  return runner_.Run(targets_, pause_at);
}

double FirstLook::Pixels(int places) const {
  return static_cast<double>(film_.Sampled().Area()) * places / BlockOrder::places;
}

RenderState FirstLook::TakeState() {
  RenderState state;
  for (int i = 0; i < film_.Blocks(); ++i) state.blocks.push_back(std::move(film_[i]));
  state.schedule.targets = std::move(targets_);
  state.rays = runner_.Rays();
  return state;
}

}  // namespace ray
