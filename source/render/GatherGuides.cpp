#include "source/render/GatherGuides.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "source/film/denoise/Denoiser.h"
#include "source/integrate/Guide.h"
#include "source/render/Render.h"
#include "source/render/RenderBlock.h"

namespace ray {
namespace {

// Guides whose range within a pixel exceeds this have an edge there. The difference of the streams' means must not
// decide: where they agree by chance, both would be trusted with the same error.
constexpr double edge = 0.06;

// Without a budget, guides are refined by this number of rays per camera ray of the pixels around, on average over a
// square of them. On the scenes of script/denoise_table.sh this leaves 2% more error than any number of rays, and
// guides take 0.2 to 0.65 times the rays of the render.
constexpr double refining_rays = 6;
constexpr int sharing_radius = 6;
// The share of a pixel depends on those around it, whose levels depend on their neighbors in turn.
static_assert(denoise_reach_of_best_guides + sharing_radius + 1 <= denoise_reach);

static_assert(std::tuple_size_v<PixelGuide> == std::tuple_size_v<Guide>);

/// Sums of the guides of some camera rays of a pixel.
struct Tally {
  Guide sum{}, low, high;
  std::uint32_t count = 0;

  Tally() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void Add(const Guide& guide) {
    for (std::size_t k = 0; k < guide.size(); ++k) {
      const double value = std::isfinite(guide[k]) ? guide[k] : 0;
      sum[k] += value;
      low[k] = std::min(low[k], value);
      high[k] = std::max(high[k], value);
    }
    ++count;
  }
  void Add(const Tally& o) {
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += o.sum[k];
      low[k] = std::min(low[k], o.low[k]);
      high[k] = std::max(high[k], o.high[k]);
    }
    count += o.count;
  }
  PixelGuide Mean() const {
    PixelGuide mean{};
    for (std::size_t k = 0; k < sum.size(); ++k) mean[k] = static_cast<float>(sum[k] / std::max(1u, count));
    return mean;
  }
  /// Returns the largest range of a component of the guides; light counts only as far as a screen shows it.
  double Range() const {
    double most = 0;
    for (std::size_t k = 0; k < sum.size() && count > 0; ++k)
      most = std::max(most, std::min(high[k], 1.0) - std::min(low[k], 1.0));
    return most;
  }
};

/// The allotment of additional samples to pixels, in proportion to the range of their guides. For a given number of
/// samples this minimizes the sum of the means' variances. Pixels are grouped by that range in steps of a hundredth.
/// Weighing by the cost of each pixel's rays did not reduce the error.
///   source   Neyman, On the two different aspects of the representative method (1934)
class Allotment {
 public:
  using Level = std::uint8_t;
  /// The level of a range. Normals differ by up to 2.
  static Level LevelOf(double range) { return static_cast<Level>(std::ceil(std::min(range, 2.0) * steps)); }

  void Add(Level level, double rays_per_sample) { rays_per_sample_[level] += rays_per_sample; }
  /// Limits the samples of each pixel to `most`, and the rays of all together to about `rays`.
  void Share(double rays, double most) {
    most_ = most;
    double too_much = most + 1;  // with that many even the lowest level has all its samples
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
      const double samples = (samples_per_level_ + too_much) / 2;
      (Rays(samples) <= rays ? samples_per_level_ : too_much) = samples;
    }
  }
  /// Returns the number of rays of all pixels if only `most` limited them.
  double MostRays() const { return Rays(most_ + 1); }
  std::uint32_t SamplesOf(Level level) const { return Samples(level, samples_per_level_); }

 private:
  static constexpr double steps = 100;

  std::uint32_t Samples(std::size_t level, double samples_per_level) const {
    return static_cast<std::uint32_t>(std::min(samples_per_level * static_cast<double>(level), most_));
  }
  double Rays(double samples_per_level) const {
    double sum = 0;
    for (std::size_t level = 0; level < rays_per_sample_.size(); ++level)
      sum += rays_per_sample_[level] * Samples(level, samples_per_level);
    return sum;
  }

  std::array<double, std::numeric_limits<Level>::max() + 1> rays_per_sample_{};  // sums over the pixels of a level
  double most_ = 0, samples_per_level_ = 0;
};

class Gathering {
 public:
  Gathering(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film,
            WorkMeter& meter)
      : film_(film),
        meter_(meter),
        seed_(settings.seed),
        tracer_(world, accelerator, TraceSettingsOf(settings)),
        camera_(CameraRaysOf(world, settings)),
        refining_camera_(CameraRaysOf(world, settings, Refinement().samples)),
        ranges_(film.Region().Width(), film.Region().Height()),
        rays_per_sample_(ranges_.Width(), ranges_.Height()) {
    for (auto* guides : {found_.guides.of_stream, found_.guides.best})
      for (int stream = 0; stream < Film::parts; ++stream)
        guides[stream] = Pixels<PixelGuide>(ranges_.Width(), ranges_.Height());
  }

  GatheredGuides Gather(const RefiningBudget& refining) {
    meter_.Expect(2 * std::int64_t{Chunks()});
    ForEachPixel([&](int x, int y, TraceState& state) { FollowSamples(x, y, state); });
    for (const TraceState& state : states_) found_.following_rays += state.rays.Total();
    if (meter_.IsStopped()) return std::move(found_);
    const std::optional<Refinement> budget = refining(found_.following_rays);
    budget ? Allot(*budget) : ShareAround();
    ForEachPixel([&](int x, int y, TraceState& state) {
      if (const Allotment::Level level = LevelAt(x, y))
        Refine(x, y, budget ? allotment_.SamplesOf(level) : SamplesInProportion(x, y, level), state);
    });
    for (const TraceState& state : states_) found_.rays += state.rays;
    return std::move(found_);
  }

 private:
  static constexpr int chunk = 64;  // pixels of a row that one thread takes at once
  int ChunksOfRow() const { return (ranges_.Width() + chunk - 1) / chunk; }
  int Chunks() const { return ChunksOfRow() * ranges_.Height(); }

  /// Calls work for each pixel; x and y count from the lower left corner of the region.
  template <typename Work>
  void ForEachPixel(const Work& work) {
    tbb::parallel_for(0, Chunks(), [&](int i) {
      const int y = i / ChunksOfRow(), x0 = i % ChunksOfRow() * chunk, x1 = std::min(x0 + chunk, ranges_.Width());
      TraceState& state = states_.local();
      for (int x = x0; x < x1 && !meter_.IsStopped(); ++x) work(x, y, state);
      meter_.PartIsDone();
    });
  }

  const Film::Block& BlockOf(int x, int y) const {
    return film_[film_.BlockOf(film_.Region().x0 + x, film_.Region().y0 + y)];
  }

  void FollowSamples(int x, int y, TraceState& state) {
    const Film::Block& block = BlockOf(x, y);
    const std::uint64_t rays_before = state.rays.Total();
    Tally both;
    for (int stream = 0; stream < Film::parts; ++stream) {
      const Tally tally = Trace(x, y, stream, camera_, block.samples[stream], state);
      found_.guides.of_stream[stream].At(x, y) = tally.Mean();
      both.Add(tally);
    }
    for (auto& best : found_.guides.best) best.At(x, y) = both.Mean();
    ranges_.At(x, y) = static_cast<float>(both.Range());
    rays_per_sample_.At(x, y) =
        static_cast<float>(state.rays.Total() - rays_before) / static_cast<float>(std::max(1u, both.count));
  }

  /// Returns how uneven the pixel's guides are; 0 if no edge is near. Since an edge may cross its corner between its
  /// samples, the level is at least half of that of its neighbors.
  Allotment::Level LevelAt(int x, int y) const {
    float most = 0;
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i) most = std::max(most, ranges_.Clamped(i, j));
    return most > edge ? Allotment::LevelOf(std::max(ranges_.At(x, y), most / 2)) : Allotment::Level{0};
  }

  void Allot(const Refinement& refinement) {
    std::uint32_t most = refinement.samples;
    for (int y = 0; y < ranges_.Height(); ++y)
      for (int x = 0; x < ranges_.Width(); ++x) {
        most = std::max(most, BlockOf(x, y).Samples());
        if (const Allotment::Level level = LevelAt(x, y)) allotment_.Add(level, double{rays_per_sample_.At(x, y)});
      }
    allotment_.Share(static_cast<double>(refinement.rays), most);
    found_.refining_rays_of_use = allotment_.MostRays();
  }

  /// Sets up sharing without a total budget: each pixel has a share of the samples of its surroundings, by the same
  /// rule.
  void ShareAround() {
    Pixels<std::array<float, 1>> rays(ranges_.Width(), ranges_.Height());  // of a sample in all pixels
    for (int y = 0; y < rays.Height(); ++y)
      for (int x = 0; x < rays.Width(); ++x)
        rays.At(x, y)[0] = static_cast<float>(LevelAt(x, y)) * rays_per_sample_.At(x, y);
    rays_around_ = MeansAround(rays, sharing_radius, -1);
  }
  std::uint32_t SamplesInProportion(int x, int y, Allotment::Level level) const {
    const std::uint32_t own = BlockOf(x, y).Samples(), most = std::max(Refinement().samples, own);
    const double samples = refining_rays * own * level / rays_around_.At(x, y)[0];
    return static_cast<std::uint32_t>(std::min<double>(samples, most));
  }

  /// Computes each stream's best guide: over its own camera rays and `count` others. With few others it is close to the
  /// stream's own guide. Over both streams' rays it would share its noise with the other stream, which must measure its
  /// error.
  void Refine(int x, int y, std::uint32_t count, TraceState& state) {
    constexpr int others = Film::parts;  // a stream other than those of the samples
    const Tally refined = Trace(x, y, others, refining_camera_, count, state);
    for (int stream = 0; stream < Film::parts; ++stream) {
      const auto own = static_cast<float>(BlockOf(x, y).samples[stream]), added = static_cast<float>(count);
      const PixelGuide own_mean = found_.guides.of_stream[stream].At(x, y), mean = refined.Mean();
      PixelGuide& best = found_.guides.best[stream].At(x, y);
      for (std::size_t k = 0; k < best.size(); ++k) best[k] = (own * own_mean[k] + added * mean[k]) / (own + added);
    }
  }

  Tally Trace(int x, int y, int stream, const CameraRays& camera, std::uint32_t count, TraceState& state) const {
    const int column = film_.Region().x0 + x, row = film_.Region().y0 + y;
    const RandomKey key = PixelKey(seed_, column, row, stream);
    std::array<PixelSample, GuideTracer::most_at_once> due;
    std::array<CameraSample, GuideTracer::most_at_once> samples;
    std::array<Guide, GuideTracer::most_at_once> guides;
    Tally tally;
    for (std::uint32_t first = 0; first < count; first += GuideTracer::most_at_once) {
      const auto size = std::min<std::size_t>(samples.size(), count - first);
      for (std::uint32_t i = 0; i < size; ++i) due[i] = {column, row, key, first + i};
      camera.MakeEach(std::span(due).first(size), samples);
      const auto unseen = std::ranges::remove_if(std::span(samples).first(size),
                                                 [](const CameraSample& sample) { return !sample.HasRay(); });
      const std::size_t traced = size - unseen.size();
      if (traced > 0) tracer_.Trace(std::span(samples).first(traced), std::span(guides).first(traced), state);
      std::ranges::fill(std::span(guides).first(size).subspan(traced), Guide{});
      for (std::size_t i = 0; i < size; ++i) tally.Add(guides[i]);
    }
    return tally;
  }

  const Film& film_;
  WorkMeter& meter_;
  const RandomKey seed_;
  const GuideTracer tracer_;
  const CameraRays camera_, refining_camera_;
  Pixels<float> ranges_, rays_per_sample_;
  Allotment allotment_;
  Pixels<std::array<float, 1>> rays_around_;  // means over a square of level times rays per sample
  GatheredGuides found_;
  tbb::enumerable_thread_specific<TraceState> states_;
};

}  // namespace

GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film, const RefiningBudget& refining, WorkMeter& meter) {
  return Gathering(world, accelerator, settings, film, meter).Gather(refining);
}

}  // namespace ray
