#include "source/render/forecast/DenoiseForecast.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "source/film/PixelRectangle.h"
#include "source/film/denoise/Denoise.h"
#include "source/film/denoise/DenoisedError.h"
#include "source/render/GatherGuides.h"
#include "source/render/Threads.h"
#include "source/render/forecast/SecondsOf.h"
#include "source/sample/Random.h"

namespace ray {
namespace {

// Fraction of the pixels at which a forecast looks: in small rectangles for guides, whose cost depends on the visible
// scene, and in a larger one for filters, whose cost hardly does but which are slower on small images.
constexpr double looked_at = 1.0 / 32;
constexpr int least_places = 12, most_rows_of_place = 16, rows_for_filters = 64;
constexpr double growth_between_looks = 1.3;  // minimum, of the samples

template <typename Work>
void InArena(int threads, const Work& work) {
  tbb::task_arena arena(ThreadsFor(threads));
  arena.execute(work);
}

R2::Image Noise(int side, std::uint64_t seed) {
  R2::Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const RandomKey key = RandomKey(seed).Child(static_cast<std::uint64_t>(y * side + x));
      image.Set(x, y, {key.Child(0).Number(), key.Child(1).Number(), key.Child(2).Number()});
    }
  return image;
}

/// Returns guides that contain the light itself, with which pixels are as similar as possible: the slowest case.
Guides InformativeGuides(const R2::Image& light) {
  Pixels<PixelGuide> pixels(light.Width(), light.Height());
  for (int y = 0; y < light.Height(); ++y)
    for (int x = 0; x < light.Width(); ++x) {
      const R2::Color c = light.At(x, y);
      for (std::size_t k = 0; k < std::tuple_size_v<PixelGuide>; ++k)
        pixels.At(x, y)[k] = static_cast<float>(k % 3 == 0 ? c.r : k % 3 == 1 ? c.g : c.b);
    }
  return {{pixels, pixels}, {pixels, pixels}};
}

double SecondsToFilterNoise(int side, const DenoiseFilters& filters) {
  constexpr int attempts = 3;
  const R2::Image a = Noise(side, 1), b = Noise(side, 2);
  const Guides guides = InformativeGuides(b);
  return LeastSecondsOf(attempts, [&] { Denoise(a, b, guides, filters); });
}

}  // namespace

double SecondsToFilter(const RenderSettings& settings) {
  constexpr int small = 64, large = 128;
  double seconds = 0;
  InArena(settings.threads, [&] {
    const DenoiseFilters filters(settings.denoiser, settings.threads);
    const double of_small = SecondsToFilterNoise(small, filters), of_large = SecondsToFilterNoise(large, filters);
    const double of_pixel = std::max(0.0, of_large - of_small) / (large * large - small * small);
    const auto pixels = static_cast<double>(MadeRegionOf(settings).Area());
    seconds = std::max(0.0, of_large + of_pixel * (pixels - large * large));
  });
  return seconds;
}

DenoiseForecast::DenoiseForecast(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                 const ErrorMeasure& measure)
    : world_(world),
      accelerator_(accelerator),
      settings_(settings),
      measure_(measure),
      pixels_(static_cast<double>(MadeRegionOf(settings).Area())),
      filter_seconds_(settings.budget.seconds_to_filter) {}

void DenoiseForecast::Look(const Film& film, double samples, std::uint64_t rays, const std::atomic<bool>* stop) {
  if (!film.HasBothParts()) return;
  render_rays_ = static_cast<double>(rays) / (pixels_ * samples);
  if (samples < growth_between_looks * looked_at_) return;
  looked_at_ = samples;
  InArena(settings_.threads, [&] {
    LookAtGuides(film, samples, stop);
    // The time of the library does not depend on the image, but strongly on its size.
    if (settings_.denoiser == Denoiser::regression) LookAtFilters(film);
  });
  ++looks_;
}

void DenoiseForecast::LookAtGuides(const Film& film, double samples, const std::atomic<bool>* stop) {
  const double pixels = looked_at * pixels_;
  const int rows = std::clamp(static_cast<int>(std::sqrt(pixels / least_places / 2)), 1, most_rows_of_place);
  const int columns = 2 * rows, places = std::max(least_places, static_cast<int>(pixels / (rows * columns)));
  std::vector<Film> parts;
  for (int i = 0; i < places; ++i)
    parts.push_back(film.Cut(SpreadRectangle(film.Region(), columns, rows, looks_ * places + i)));
  std::vector<GatheredGuides> gathered(parts.size());
  const double seconds = SecondsOf([&] {
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      WorkMeter meter({}, stop);
      const double rays = render_rays_ * samples * static_cast<double>(parts[i].Region().Area());
      const auto refining = [=](std::uint64_t) { return std::optional(Refinement{static_cast<std::uint64_t>(rays)}); };
      gathered[i] = GatherGuides(world_, accelerator_, settings_, parts[i], refining, meter);
    });
  });
  // Few samples do not find all edges. With more, all places count equally, since they differ more than looks do.
  const double weight = std::min(samples, 16.0), weight_of_sample = weight / samples;
  guides_.seconds += samples * seconds;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    guides_.pixels += weight * static_cast<double>(parts[i].Region().Area());
    guides_.rays += samples * static_cast<double>(gathered[i].rays.Total());
    guides_.following_rays += weight_of_sample * static_cast<double>(gathered[i].following_rays);
    guides_.refining_rays_of_use += weight * gathered[i].refining_rays_of_use;
  }
}

void DenoiseForecast::LookAtFilters(const Film& film) {
  const int columns = std::max(rows_for_filters, static_cast<int>(looked_at * pixels_ / rows_for_filters));
  const Film part = film.Cut(SpreadRectangle(film.Region(), columns, rows_for_filters, looks_));
  const Guides guides = InformativeGuides(part.Image());
  const DenoiseFilters filters(Denoiser::regression);
  const double seconds = SecondsOf([&] {
    const DenoisedImage denoised = Denoise(part.Part(0), part.Part(1), guides, filters);
    MeasureDenoisedError(part, denoised, measure_);
  });
  filter_seconds_ = seconds * pixels_ / static_cast<double>(part.Region().Area());
}

bool DenoiseForecast::RefinesAll(double samples) const {
  return render_rays_ * samples > guides_.refining_rays_of_use / guides_.pixels;
}

double DenoiseForecast::Seconds(double samples) const {
  if (!HasLooked()) return filter_seconds_;
  const double following = guides_.following_rays / guides_.pixels * samples;
  const double refining = RefinesAll(samples) ? guides_.refining_rays_of_use / guides_.pixels : render_rays_ * samples;
  return filter_seconds_ + pixels_ * (following + refining) * guides_.seconds / guides_.rays;
}

double DenoiseForecast::SecondsOfSample(double samples) const {
  if (!HasLooked()) return 0;
  const double rays = guides_.following_rays / guides_.pixels + (RefinesAll(samples) ? 0 : render_rays_);
  return pixels_ * rays * guides_.seconds / guides_.rays;
}

}  // namespace ray
