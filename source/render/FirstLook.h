#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "source/render/PassRunner.h"
#include "source/render/Render.h"

namespace ray {

/// The targets of a first look at an image: the first samples of `places` pixels of each block, in the order of
/// BlockOrder. The other pixels are filled from them.
PassTargets LookTargets(std::size_t blocks, int places);

/// The most places of a block, a power of 4, such that a first look at an image of so many pixels takes no longer than
/// `seconds`, or 1. `pixels_per_second`: 0 if it is not known.
int PlacesWithin(double seconds, std::int64_t pixels, double pixels_per_second);

/// First samples of an image for someone who watches it grow: they are taken where the watcher wants them, whatever
/// the time limit of the settings and also in modes that show costs. Render can resume from them.
class FirstLook {
 public:
  /// `integrator`, `settings` and `stop` must outlive this. `count` is called after each tile with all rays so far.
  FirstLook(const World& world, const Integrator& integrator, const RenderSettings& settings,
            const std::atomic<bool>* stop, const std::function<void(std::uint64_t rays)>& count);

  /// Takes the first samples of `places` pixels of each block, until `pause_at`.
  PassRunner::End Look(int places, std::chrono::steady_clock::time_point pause_at);
  /// The image so far, without gaps.
  R2::Image Image() const { return ImageOf(film_, settings_); }
  /// The number of pixels that a look at so many places takes samples of.
  double Pixels(int places) const;
  /// The state from which Render continues. Call it once, last.
  RenderState TakeState();

 private:
  const RenderSettings& settings_;
  const CameraRays camera_;
  const SampleSource source_;
  Film film_;
  PassRunner runner_;
  PassTargets targets_;
};

}  // namespace ray
