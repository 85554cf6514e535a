#pragma once

#include <atomic>
#include <cstdint>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/error/ImageError.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Estimates the time of the filters for an image of that size on this machine with its threads, in seconds, by
/// filtering images of noise, which takes about fifty milliseconds of one processor. The time of guides is not
/// included. Throws DenoiserError.
double SecondsToFilter(const RenderSettings& settings);

/// Predicts the time from the last sample of an image to its denoised version. It denoises small parts of the image,
/// again whenever passes have added a third of its samples.
///   accuracy   see docs/notes/accuracy.md: rays within a few percent; the time per ray is as steady as the machine
class DenoiseForecast {
 public:
  /// All arguments must outlive it.
  DenoiseForecast(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                  const ErrorMeasure& measure);

  /// Updates the forecast from the film, if every block has samples of both parts. `samples` per pixel and `rays` of
  /// the render are those so far; `stop` as in RenderMonitor.
  void Look(const Film& film, double samples, std::uint64_t rays, const std::atomic<bool>* stop);
  /// Discards the measurements of guides, for instance because other programs seem to have run meanwhile.
  void Forget() { guides_ = {}, looked_at_ = 0; }
  /// Returns true if there are measurements of this image's guides.
  bool HasLooked() const { return guides_.rays > 0; }

  /// Returns the seconds of denoising after that many samples per pixel.
  double Seconds(double samples) const;
  /// Returns the part of these seconds that comes after the guides.
  double FilterSeconds() const { return filter_seconds_; }
  /// Returns the seconds that a further sample per pixel adds.
  double SecondsOfSample(double samples) const;

 private:
  void LookAtGuides(const Film& film, double samples, const std::atomic<bool>* stop);
  void LookAtFilters(const Film& film);
  /// Returns true if edges have as many rays as are useful, after that many samples per pixel.
  bool RefinesAll(double samples) const;

  const World& world_;
  const Accelerator& accelerator_;
  const RenderSettings& settings_;
  const ErrorMeasure measure_;
  struct GuidesSeen {
    // sums over all looks, each times its samples: rays are faster in pixels with many
    double seconds = 0, rays = 0;
    // Sums over the pixels of all looks, each times the weight of its look.
    double pixels = 0;
    double following_rays = 0;        // per sample
    double refining_rays_of_use = 0;  // for any number of samples
  } guides_;
  double render_rays_ = 0;  // per sample
  double pixels_ = 0;       // of the image
  double filter_seconds_;   // of the image
  double looked_at_ = 0;    // samples per pixel
  int looks_ = 0;
};

}  // namespace ray
