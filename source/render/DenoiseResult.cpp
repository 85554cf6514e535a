#include "source/render/DenoiseResult.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <chrono>

#include "source/film/denoise/DenoisedError.h"
#include "source/render/GatherGuides.h"

namespace ray {

void DenoiseResult(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film,
                   const ErrorMeasure& measure, RenderResult& result) {
  if (!film.HasBothParts()) return;
  const auto start = std::chrono::steady_clock::now();
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::info::default_concurrency());
  try {
    arena.execute([&] {
      const DenoiseFilters filters(settings.denoiser, settings.threads);
      const GatheredGuides gathered = GatherGuides(world, accelerator, settings, film);
      result.rays += gathered.rays;
      const DenoisedPicture denoised = Denoise(film.Part(0), film.Part(1), gathered.guides, filters);
      result.image = denoised.Mean();
      result.denoised_by = filters.Name();
      result.error_before_denoising = result.error;
      result.error = MeasureDenoisedError(film, denoised, measure).estimate;
    });
  } catch (const DenoiserError& error) {
    result.denoise_failure = error.what();
  }
  result.denoise_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ray
