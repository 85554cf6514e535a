#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/film/denoise/Denoise.h"
#include "source/render/Render.h"

namespace ray {

/// Filters the region of a film that has both parts. Guides are refined in proportion to the samples.
DenoisedImage DenoiseFilm(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                          const Film& film);

/// Denoises the image of a render when it is complete, and also before, if the error after filtering decides when it
/// is. The image is the same, bit for bit, for any number of looks at the film before.
class ImageDenoiser {
 public:
  /// All arguments must outlive it.
  ImageDenoiser(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                const ErrorMeasure& measure, const RenderMonitor& monitor);
  ~ImageDenoiser();

  /// Returns the error after filtering of the image so far, with guides refined in proportion to the samples. Returns
  /// std::nullopt if the film lacks a part, the filters fail or the monitor requests a stop. Shows no progress.
  std::optional<MeasuredError> ErrorLeft(const Film& film, const UnseenLight& unseen);
  /// True if the monitor ended a look, so that its error is unknown.
  bool WasStopped() const { return was_stopped_; }
  /// True if a library failed, so that the image will not be denoised.
  bool HasFailed() const { return !failure_.empty(); }

  /// Denoises the image of a complete render. If the film is that of the last look, the image is that look's. Otherwise
  /// guides are refined in proportion to the samples, by as many rays as there is time for until `end_of_guides`, or as
  /// in the replayed render. Reports its progress.
  /// If a library fails, the image is unchanged and the result contains the reason. If the monitor requests a stop, the
  /// image is unchanged as well, and the render is no longer complete. It is also unchanged if `is_worse` of the error
  /// after filtering.
  void Finish(const Film& film, std::optional<std::chrono::steady_clock::time_point> end_of_guides,
              const std::function<bool(const MeasuredError&)>& is_worse, RenderResult& result);

 private:
  struct Denoised;
  void Denoise(const Film& film, const UnseenLight& unseen,
               std::optional<std::chrono::steady_clock::time_point> end_of_guides, bool shows_progress);

  const World& world_;
  const Accelerator& accelerator_;
  const RenderSettings& settings_;
  const ErrorMeasure measure_;
  const RenderMonitor& monitor_;
  std::unique_ptr<Denoised> last_;  // null unless the last attempt succeeded
  std::string failure_;
  bool was_stopped_ = false;
  double seconds_ = 0;  // of all attempts
};

}  // namespace ray
