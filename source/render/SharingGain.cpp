#include "source/render/SharingGain.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "source/integrate/SharedPaths.h"
#include "source/render/RenderBlock.h"
#include "source/render/RenderInputs.h"
#include "source/render/Tiles.h"

namespace ray {
namespace {

constexpr std::uint32_t indices = 4;  // samples of each pixel of the pilot
constexpr std::uint32_t groups = 32;
constexpr double little = 1.1;  // gain of a fourth of the groups with which the others are not traced

/// Luminances of a pixel's samples.
struct PilotPixel {
  std::array<double, indices> alone{}, shared{};
};

double MeanOf(const std::array<double, indices>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / indices;
}

double VarianceOf(const std::array<double, indices>& values) {
  const double mean = MeanOf(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / (indices - 1);
}

double Cost(const RayCounts& rays) {
  constexpr double cost_of_shadow_ray = 0.5;
  const auto shadow = static_cast<double>(rays.kinds[static_cast<std::size_t>(RayKind::shadow)].rays);
  return static_cast<double>(rays.Total()) - (1 - cost_of_shadow_ray) * shadow;
}

/// Traces the pilot's paths, each once, and computes what their samples are with and without sharing.
class Pilot {
 public:
  Pilot(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
        const std::atomic<bool>* stop)
      : integrator_(IntegratorOf(world, accelerator, settings)),
        camera_(CameraRaysOf(world, settings)),
        seed_(settings.seed) {
    state_.stop = stop;
    RenderSettings whole = settings;
    whole.crop.reset();
    const Film film = EmptyFilmOf(whole);
    const Tiles squares(film, SharedPaths::side);
    for (std::uint32_t group = 0; group < groups && !state_.IsStopped(); ++group) {
      if (group == groups / 4 && Gain() < little) break;
      std::vector<PixelSample> pixels;
      for (const int block : squares.BlocksOf(squares.Spread(static_cast<int>(group) % squares.Count()))) {
        const PixelRectangle of_block = film.PixelsOf(block);
        for (int row = of_block.y0; row < of_block.y1; ++row)
          for (int column = of_block.x0; column < of_block.x1; ++column)
            pixels.push_back({column, row, PixelKey(RandomKey(settings.seed), column, row, 0)});
      }
      TraceGroup(pixels, RandomKey(settings.seed).Child(group));
    }
  }

  double Gain() const { return shared_ > 0 ? alone_ / shared_ * cost_alone_ / cost_shared_ : 1; }

 private:
  /// Traces one group of a square's pixels.
  void TraceGroup(const std::vector<PixelSample>& square, const RandomKey& key) {
    const auto all = static_cast<std::uint32_t>(square.size()), count = std::min(all, SharedPaths::group_size);
    const Shuffle shuffle(all, key);
    std::vector<PilotPixel> pixels(count);
    for (std::uint32_t index = 0; index < indices; ++index) {
      std::vector<PixelSample> due;
      for (std::uint32_t i = 0; i < count; ++i) {
        due.push_back(square[shuffle(i)]);
        due.back().index = index;
      }
      std::vector<CameraSample> samples(count);
      camera_.MakeEach(due, samples);
      std::vector<R2::Color> alone(count), shared(count);
      TraceSamples(samples, alone, shared);
      for (std::uint32_t i = 0; i < count; ++i) {
        pixels[i].alone[index] = Luminance(alone[i]);
        pixels[i].shared[index] = Luminance(shared[i]);
      }
    }
    AddVariances(pixels);
  }

  /// Adds relative variances, since errors in dark places are as visible as larger ones in bright places.
  void AddVariances(std::span<const PilotPixel> pixels) {
    double sum = 0;
    for (const PilotPixel& pixel : pixels) sum += MeanOf(pixel.shared);
    const double mean = sum / static_cast<double>(pixels.size());
    if (mean == 0) return;
    for (const PilotPixel& pixel : pixels) {
      const double light = std::max(mean, MeanOf(pixel.shared));
      alone_ += VarianceOf(pixel.alone) / (light * light);
      shared_ += VarianceOf(pixel.shared) / (light * light);
    }
  }

  void TraceSamples(std::span<const CameraSample> samples, std::span<R2::Color> alone, std::span<R2::Color> shared) {
    if (!std::ranges::all_of(samples, &CameraSample::HasRay)) return;  // at the edge of the camera's view
    paths_.Begin(samples.size(), RandomKey(seed_));
    state_.shared = &paths_;
    state_.rays = {};
    integrator_->Li(samples, alone, state_);
    cost_alone_ += Cost(state_.rays);
    std::ranges::copy(alone, shared.begin());
    paths_.GiveBack(alone);
    integrator_->AddShared(shared, state_);
    cost_shared_ += Cost(state_.rays);
  }

  std::unique_ptr<const Integrator> integrator_;
  CameraRays camera_;
  std::uint64_t seed_;
  SharedPaths paths_;
  TraceState state_;
  double alone_ = 0, shared_ = 0;  // sums of variances
  double cost_alone_ = 0, cost_shared_ = 0;
};

}  // namespace

std::optional<bool> SharesLight(const RenderSettings& settings) {
  const bool may_share = settings.mode == RenderMode::path && settings.trace.max_depth > 0 && settings.trace.shadows &&
                         settings.budget.adaptive != Adaptive::neighbors;
  if (!may_share || settings.share != Sharing::automatic) return may_share && settings.share == Sharing::on;
  if (settings.samples == 1 && !settings.budget.IsOpen()) return false;  // the pilot would take longer
  return {};
}

bool SharesLight(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                 const std::atomic<bool>* stop) {
  if (const auto known = SharesLight(settings)) return *known;
  // Of bench/scenes, firefly gains 1.2 to 1.4 and is 0.86 times as efficient as displayed; glass, with 1.6 to 2.0, 1.25
  // times. Denoised, glass is 0.8 times as efficient; bright, with 2.2 to 3.3, 1.08 times.
  constexpr double least = 1.7, least_if_denoised = 2.5;
  return !world.Moves() &&
         SharingGain(world, accelerator, settings, stop) >= (settings.denoise ? least_if_denoised : least);
}

double SharingGain(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                   const std::atomic<bool>* stop) {
  return Pilot(world, accelerator, settings, stop).Gain();
}

}  // namespace ray
