#pragma once

#include <atomic>
#include <cstdint>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/error/PictureError.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// How long the filters of a picture of that size take on this machine with its threads, in seconds: told by filtering
/// pictures of noise, which takes some fifty milliseconds of one processor. Guides come on top. Throws DenoiserError.
double SecondsToFilter(const RenderSettings& settings);

/// Predicts how long it would take to denoise an image once its last sample is taken. It denoises small parts of the
/// image, again whenever passes have added a third of its samples.
///   accuracy   as docs/accuracy.md has it: rays within some percent; what one takes, as steady as the machine
class DenoiseForecast {
 public:
  /// All must outlive it.
  DenoiseForecast(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                  const ErrorMeasure& measure);

  /// What the film tells, if every block has samples of both parts. `samples` per pixel, `rays` of the render, both so
  /// far; `stop` as in RenderMonitor.
  void Look(const Film& film, double samples, std::uint64_t rays, const std::atomic<bool>* stop);
  /// Forgets what was seen of guides, for instance because other programs seem to have run meanwhile.
  void Forget() { guides_ = {}, looked_at_ = 0; }
  /// Whether anything is known of this picture's guides.
  bool HasLooked() const { return guides_.rays > 0; }

  /// Seconds after so many samples per pixel.
  double Seconds(double samples) const;
  /// The part of these seconds that comes after the guides.
  double FilterSeconds() const { return filter_seconds_; }
  /// Seconds that a further sample per pixel adds.
  double SecondsOfSample(double samples) const;

 private:
  void LookAtGuides(const Film& film, double samples, const std::atomic<bool>* stop);
  void LookAtFilters(const Film& film);
  /// Whether edges have as many rays as are of use, after so many samples per pixel.
  bool RefinesAll(double samples) const;

  const World& world_;
  const Accelerator& accelerator_;
  const RenderSettings& settings_;
  const ErrorMeasure measure_;
  struct GuidesSeen {
    double seconds = 0, rays = 0;  // of all looks, each times its samples: rays are faster where a pixel has many
    // Sums over the pixels of all looks, each times the weight of its look.
    double pixels = 0;
    double following_rays = 0;        // per sample
    double refining_rays_of_use = 0;  // however many samples
  } guides_;
  double render_rays_ = 0;  // per sample
  double pixels_ = 0;       // of the picture
  double filter_seconds_;   // of the picture
  double looked_at_ = 0;    // samples per pixel
  int looks_ = 0;
};

}  // namespace ray
