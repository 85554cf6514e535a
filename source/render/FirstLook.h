#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "source/render/PassRunner.h"
#include "source/render/Render.h"

namespace ray {

/// Returns the targets of a first look at an image: the first samples of `places` pixels of each block, in the order of
/// BlockOrder. The other pixels are filled from them.
PassTargets LookTargets(std::size_t blocks, int places);

/// Returns the most places of a block, a power of 4, with which a first look at an image of that many pixels takes at
/// most `seconds`; at least 1. `pixels_per_second`: 0 if it is unknown.
int PlacesWithin(double seconds, std::int64_t pixels, double pixels_per_second);

/// The first samples of an image that grows on the screen. They are taken in the order that the viewer requests,
/// regardless of the time limit of the settings, and also in modes that show costs. Render can resume from them.
class FirstLook {
 public:
  /// `integrator`, `settings` and `stop` must outlive this. `count` is called after each tile with all rays so far.
  FirstLook(const World& world, const Integrator& integrator, const RenderSettings& settings,
            const std::atomic<bool>* stop, const std::function<void(std::uint64_t rays)>& count);

  /// Takes the first samples of `places` pixels of each block, until `pause_at`.
  PassRunner::End Look(int places, std::chrono::steady_clock::time_point pause_at);
  /// Returns the image so far, without gaps.
  R2::Image Image() const { return ImageOf(film_, settings_); }
  /// Returns the number of pixels of which a look at that many places takes samples.
  double Pixels(int places) const;
  /// Returns the state from which Render continues. Call it once, last.
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
