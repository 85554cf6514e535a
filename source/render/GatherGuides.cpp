#include "source/render/GatherGuides.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "source/integrate/Guide.h"
#include "source/render/Render.h"
#include "source/render/RenderBlock.h"
#include "source/render/Schedule.h"

namespace ray {
namespace {

// At least. 32 had a tenth more error on the scenes of script/denoise_table.sh, 256 hardly less.
constexpr std::uint32_t refined_samples = 128;
constexpr std::uint64_t refined_key = 3;  // beneath a pixel's key; see SampleSource
// Guides that vary by more within a pixel have an edge there. Whether the streams' means differ must not decide: where
// they agree by chance, both would be trusted though both are wrong alike.
constexpr double edge = 0.06;

static_assert(std::tuple_size_v<PixelGuide> == std::tuple_size_v<Guide>);

/// The guides of some camera rays of a pixel.
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
  bool HasEdge() const {
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (high[k] - low[k] > edge) return true;
    return false;
  }
};

class Gathering {
 public:
  Gathering(const World& world, const Accelerator& accelerator, const RenderSettings& settings, const Film& film)
      : film_(film),
        seed_(settings.seed),
        tracer_(world, accelerator, TraceSettingsOf(settings)),
        camera_(CameraRaysOf(world, settings)),
        refining_camera_(CameraRaysOf(world, settings, refined_samples)),
        has_edge_(film.Region().Width(), film.Region().Height()) {
    for (auto& guides : found_.guides.of_stream) guides = Pixels<PixelGuide>(has_edge_.Width(), has_edge_.Height());
    found_.guides.best = Pixels<PixelGuide>(has_edge_.Width(), has_edge_.Height());
  }

  GatheredGuides Gather() {
    ForEachPixel([&](int x, int y, TraceState& state) { FollowSamples(x, y, state); });
    ForEachPixel([&](int x, int y, TraceState& state) {
      if (IsNearEdge(x, y)) Refine(x, y, state);
    });
    for (const TraceState& state : states_) found_.rays += state.rays;
    return std::move(found_);
  }

 private:
  /// x and y count from the lower left corner of the region.
  template <typename Work>
  void ForEachPixel(const Work& work) {
    tbb::parallel_for(0, has_edge_.Height(), [&](int y) {
      for (int x = 0; x < has_edge_.Width(); ++x) work(x, y, states_.local());
    });
  }

  const Film::Block& BlockOf(int x, int y) const {
    return film_[film_.BlockOf(film_.Region().x0 + x, film_.Region().y0 + y)];
  }

  void FollowSamples(int x, int y, TraceState& state) {
    const Film::Block& block = BlockOf(x, y);
    Tally both;
    for (int stream = 0; stream < Film::parts; ++stream) {
      const Tally tally = Trace(x, y, stream, camera_, block.samples[stream], state);
      found_.guides.of_stream[stream].At(x, y) = tally.Mean();
      both.Add(tally);
    }
    found_.guides.best.At(x, y) = both.Mean();
    has_edge_.At(x, y) = both.HasEdge();
  }

  /// An edge may cross the corner of a pixel between its samples.
  bool IsNearEdge(int x, int y) const {
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i)
        if (has_edge_.Clamped(i, j)) return true;
    return false;
  }

  void Refine(int x, int y, TraceState& state) {
    constexpr int stream = Film::parts;  // another than those of the samples
    const std::uint32_t count = std::max(refined_samples, BlockOf(x, y).Samples());
    found_.guides.best.At(x, y) = Trace(x, y, stream, refining_camera_, count, state).Mean();
  }

  Tally Trace(int x, int y, int stream, const CameraRays& camera, std::uint32_t count, TraceState& state) const {
    const int column = film_.Region().x0 + x, row = film_.Region().y0 + y;
    const RandomKey key = PixelKey(seed_, column, row, stream);
    std::array<CameraSample, GuideTracer::most_at_once> samples;
    std::array<Guide, GuideTracer::most_at_once> guides;
    Tally tally;
    for (std::uint32_t first = 0; first < count; first += samples.size()) {
      const auto size = std::min<std::size_t>(samples.size(), count - first);
      for (std::uint32_t i = 0; i < size; ++i) samples[i] = camera(column, row, key, first + i);
      tracer_.Trace(std::span(samples).first(size), std::span(guides).first(size), state);
      for (std::size_t i = 0; i < size; ++i) tally.Add(guides[i]);
    }
    return tally;
  }

  const Film& film_;
  const RandomKey seed_;
  const GuideTracer tracer_;
  const CameraRays camera_, refining_camera_;
  Pixels<unsigned char> has_edge_;
  GatheredGuides found_;
  tbb::enumerable_thread_specific<TraceState> states_;
};

}  // namespace

GatheredGuides GatherGuides(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                            const Film& film) {
  return Gathering(world, accelerator, settings, film).Gather();
}

}  // namespace ray
