#include "source/render/DenoiseResult.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "source/film/denoise/DenoisedError.h"
#include "source/render/GatherGuides.h"
#include "source/render/Threads.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

using Clock = std::chrono::steady_clock;

WorkMeter MeterOf(RenderPhase phase, const RenderMonitor& monitor) {
  const auto tell = [&monitor, phase](std::int64_t done, std::int64_t total) {
    if (monitor.tile_done) monitor.tile_done({done, total, 0, phase});
  };
  return {tell, monitor.stop};
}

/// What guides are refined by: as before, in a replay, or by so many rays as there is time for, or in proportion.
class Refining {
 public:
  Refining(const RenderSettings& settings, std::optional<Clock::time_point> end)
      : again_(settings.replay ? settings.replay->refinement : std::nullopt), end_(end) {}

  std::optional<Refinement> operator()(std::uint64_t following_rays) const {
    if (again_ || !end_) return again_;
    constexpr double most = 1e15;                   // a picture of any size has no use for more
    constexpr std::uint32_t samples_in_time = 512;  // for time that is left, which nothing else has a use for
    const double seconds_left = -SecondsSince(*end_);
    constexpr double price_at_edges = 1.15;  // of a ray, beside those that were followed
    const double rays_per_second = static_cast<double>(following_rays) / (price_at_edges * SecondsSince(start_));
    const double rays = std::clamp(rays_per_second * seconds_left, 0.0, most);
    return Refinement{static_cast<std::uint64_t>(rays), samples_in_time};
  }

 private:
  const Clock::time_point start_ = Clock::now();
  const std::optional<Refinement> again_;
  const std::optional<Clock::time_point> end_;
};

GatheredGuides GatherAndCount(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                              const Film& film, std::optional<Clock::time_point> end, const RenderMonitor& monitor,
                              RenderResult& result) {
  const auto start = Clock::now();
  const Refining refining(settings, end);
  const auto noted = [&](std::uint64_t following_rays) { return result.refinement = refining(following_rays); };
  WorkMeter meter = MeterOf(RenderPhase::guides, monitor);
  GatheredGuides gathered = GatherGuides(world, accelerator, settings, film, noted, meter);
  result.rays += gathered.rays;
  result.guide_rays = gathered.rays.Total();
  result.guide_seconds = SecondsSince(start);
  return gathered;
}

/// The region of a film, of an image of all that it makes.
R2::Image RegionIn(const R2::Image& made, const Film& film) {
  const PixelRectangle &region = film.Region(), &all = film.Made();
  R2::Image image(region.Width(), region.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, made.At(region.x0 - all.x0 + x, region.y0 - all.y0 + y));
  return image;
}

DenoisedPicture DenoisedRegion(const Film& film, const Film& all, const Guides& guides, const DenoiseFilters& filters,
                               WorkMeter& meter) {
  const DenoisedPicture denoised = Denoise(all.Part(0), all.Part(1), guides, filters, meter);
  return {{RegionIn(denoised.of_stream[0], film), RegionIn(denoised.of_stream[1], film)}};
}

}  // namespace

DenoisedPicture DenoiseFilm(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film) {
  const Film all = film.WithSurroundings();
  WorkMeter meter;
  const auto in_proportion = [](std::uint64_t) { return std::optional<Refinement>(); };
  const GatheredGuides gathered = GatherGuides(world, accelerator, settings, all, in_proportion, meter);
  return DenoisedRegion(film, all, gathered.guides, DenoiseFilters(settings.denoiser, settings.threads), meter);
}

void DenoiseResult(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film,
                   const ErrorMeasure& measure, std::optional<Clock::time_point> end_of_guides,
                   const RenderMonitor& monitor, RenderResult& result) {
  const std::optional<Film> copy = film.HasSurroundings() ? std::optional(film.WithSurroundings()) : std::nullopt;
  const Film& all = copy ? *copy : film;
  if (!all.HasBothParts()) return;
  const auto start = Clock::now();
  tbb::task_arena arena(ThreadsFor(settings.threads));
  try {
    arena.execute([&] {
      const DenoiseFilters filters(settings.denoiser, settings.threads);
      const GatheredGuides gathered = GatherAndCount(world, accelerator, settings, all, end_of_guides, monitor, result);
      WorkMeter meter = MeterOf(RenderPhase::filters, monitor);
      if (meter.IsStopped()) return;
      const DenoisedPicture denoised = DenoisedRegion(film, all, gathered.guides, filters, meter);
      if (meter.IsStopped()) return;
      result.image = denoised.Mean();
      result.denoised_by = filters.Name();
      result.error_before_denoising = result.error;
      MeasuredError measured = MeasureDenoisedError(film, denoised, measure);
      AllowFor(result.unseen, measure, measured);
      result.error = measured.estimate;
    });
  } catch (const DenoiserError& error) {
    result.denoise_failure = error.what();
  }
  if (result.denoised_by.empty() && monitor.stop && *monitor.stop) result.stop = Stop::request;
  result.denoise_seconds = SecondsSince(start);
}

}  // namespace ray
