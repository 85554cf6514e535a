#include "source/render/ImageDenoiser.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

#include "source/film/denoise/DenoisedError.h"
#include "source/render/GatherGuides.h"
#include "source/render/Threads.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

using Clock = std::chrono::steady_clock;

WorkMeter MeterOf(RenderPhase phase, const RenderMonitor& monitor) {
  const auto report = [&monitor, phase](std::int64_t done, std::int64_t total) {
    if (monitor.tile_done) monitor.tile_done({done, total, 0, phase});
  };
  return {report, monitor.stop};
}

/// The number of rays that refine guides: in a replay that of the earlier render, otherwise as many as there is time
/// for, or without a time limit in proportion to the samples.
class Refining {
 public:
  Refining(const RenderSettings& settings, std::optional<Clock::time_point> end)
      : again_(settings.replay ? settings.replay->refinement : std::nullopt), end_(end) {}

  std::optional<Refinement> operator()(std::uint64_t following_rays) const {
    if (again_ || !end_) return again_;
    constexpr double most = 1e15;                   // more than an image of any size needs
    constexpr std::uint32_t samples_in_time = 512;  // for the time that is left, which has no better use
    const double seconds_left = -SecondsSince(*end_);
    constexpr double price_at_edges = 1.15;  // of a ray, relative to those over camera rays
    const double rays_per_second = static_cast<double>(following_rays) / (price_at_edges * SecondsSince(start_));
    const double rays = std::clamp(rays_per_second * seconds_left, 0.0, most);
    return Refinement{static_cast<std::uint64_t>(rays), samples_in_time};
  }

 private:
  const Clock::time_point start_ = Clock::now();
  const std::optional<Refinement> again_;
  const std::optional<Clock::time_point> end_;
};

/// Returns the region of a film from an image of all pixels that it computes.
R2::Image RegionIn(const R2::Image& made, const Film& film) {
  const PixelRectangle &region = film.Region(), &all = film.Made();
  R2::Image image(region.Width(), region.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, made.At(region.x0 - all.x0 + x, region.y0 - all.y0 + y));
  return image;
}

DenoisedImage DenoisedRegion(const Film& film, const Film& all, const Guides& guides, const DenoiseFilters& filters,
                             WorkMeter& meter) {
  const DenoisedImage denoised = Denoise(all.Part(0), all.Part(1), guides, filters, meter);
  return {{RegionIn(denoised.of_stream[0], film), RegionIn(denoised.of_stream[1], film)}};
}

}  // namespace

DenoisedImage DenoiseFilm(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                          const Film& film) {
  const Film all = film.WithSurroundings();
  WorkMeter meter;
  const auto in_proportion = [](std::uint64_t) { return std::optional<Refinement>(); };
  const GatheredGuides gathered = GatherGuides(world, accelerator, settings, all, in_proportion, meter);
  return DenoisedRegion(film, all, gathered.guides, DenoiseFilters(settings.denoiser, settings.threads), meter);
}

/// A denoised image with its cost.
struct ImageDenoiser::Denoised {
  R2::Image image;
  std::string by;      // names of the filters
  MeasuredError left;  // error after filtering
  std::optional<Refinement> refinement;
  RayCounts rays;      // rays of the guides
  double samples = 0;  // samples of the film
  double guide_seconds = 0;
};

ImageDenoiser::ImageDenoiser(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                             const ErrorMeasure& measure, const RenderMonitor& monitor)
    : world_(world), accelerator_(accelerator), settings_(settings), measure_(measure), monitor_(monitor) {}

ImageDenoiser::~ImageDenoiser() = default;

std::optional<MeasuredError> ImageDenoiser::ErrorLeft(const Film& film, const UnseenLight& unseen) {
  if (!HasFailed()) Denoise(film, unseen, {}, false);
  return last_ ? std::optional(last_->left) : std::nullopt;
}

void ImageDenoiser::Finish(const Film& film, std::optional<Clock::time_point> end_of_guides,
                           const std::function<bool(const MeasuredError&)>& is_worse, RenderResult& result) {
  if (!HasFailed() && !(last_ && last_->samples == SamplesTaken(film)))
    Denoise(film, result.unseen, end_of_guides, true);
  result.denoise_failure = failure_;
  result.denoise_seconds = seconds_;
  if (was_stopped_) result.stop = Stop::request;
  if (!last_) return;
  result.rays += last_->rays;
  result.guide_rays = last_->rays.Total();
  result.guide_seconds = last_->guide_seconds;
  result.is_better_noisy = is_worse(last_->left);
  if (result.is_better_noisy) return;
  result.image = std::move(last_->image);
  result.denoised_by = last_->by;
  result.refinement = last_->refinement;
  result.error_before_denoising = result.error;
  result.error = last_->left.estimate;
}

void ImageDenoiser::Denoise(const Film& film, const UnseenLight& unseen, std::optional<Clock::time_point> end_of_guides,
                            bool shows_progress) {
  last_.reset();
  const std::optional<Film> copy = film.HasSurroundings() ? std::optional(film.WithSurroundings()) : std::nullopt;
  const Film& all = copy ? *copy : film;
  if (!all.HasBothParts()) return;
  RenderMonitor monitor;
  monitor.stop = monitor_.stop;
  if (shows_progress) monitor.tile_done = monitor_.tile_done;
  const auto start = Clock::now();
  tbb::task_arena arena(ThreadsFor(settings_.threads));
  try {
    arena.execute([&] {
      const DenoiseFilters filters(settings_.denoiser, settings_.threads);
      auto denoised = std::make_unique<Denoised>();
      const Refining refining(settings_, end_of_guides);
      const auto noted = [&](std::uint64_t following_rays) { return denoised->refinement = refining(following_rays); };
      WorkMeter of_guides = MeterOf(RenderPhase::guides, monitor);
      const GatheredGuides gathered = GatherGuides(world_, accelerator_, settings_, all, noted, of_guides);
      denoised->rays = gathered.rays;
      denoised->guide_seconds = SecondsSince(start);
      WorkMeter of_filters = MeterOf(RenderPhase::filters, monitor);
      was_stopped_ = of_filters.IsStopped();
      if (was_stopped_) return;
      const DenoisedImage image = DenoisedRegion(film, all, gathered.guides, filters, of_filters);
      was_stopped_ = of_filters.IsStopped();
      if (was_stopped_) return;
      denoised->image = image.Mean();
      denoised->by = filters.Name();
      denoised->samples = SamplesTaken(film);
      denoised->left = MeasureDenoisedError(film, image, measure_);
      AllowFor(unseen, measure_, denoised->left);
      last_ = std::move(denoised);
    });
  } catch (const DenoiserError& error) {
    failure_ = error.what();
  }
  seconds_ += SecondsSince(start);
}

}  // namespace ray
