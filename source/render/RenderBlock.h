#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "R1/BatchSize.h"
#include "source/film/Film.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrator.h"

namespace ray {

/// The key of all random choices of a pixel. `stream`: from 0, independent sample sequences.
inline RandomKey PixelKey(const RandomKey& seed, int column, int row, int stream) {
  const RandomKey key = seed.Child(static_cast<std::uint64_t>(column)).Child(static_cast<std::uint64_t>(row));
  // CameraRays uses the children below 2.
  return stream == 0 ? key : key.Child(1 + static_cast<std::uint64_t>(stream));
}

/// What the samples of a picture are made with.
struct SampleSource {
  const Integrator& integrator;
  const CameraRays& camera;
  RandomKey seed;
  bool clamps_samples = false;

  RandomKey PixelKey(int column, int row, int stream = 0) const { return ray::PixelKey(seed, column, row, stream); }
  /// The first sample of the first stream.
  PixelSample FirstSample(int column, int row) const { return {column, row, PixelKey(column, row), 0}; }
};

/// The radiances of a batch of samples, black for those without a ray.
void TraceSamples(const SampleSource& source, std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                  TraceState& state);

/// Traces camera rays a batch at a time, which integrators do faster than one by one, and gives each to
/// splat(column, row, sample, radiance) in the order they were added. What a ray brings back depends on its pixel,
/// stream and index alone, never on which others are in its batch or came before it, but for the modes that show costs,
/// where an accelerator remembers the last hit.
template <typename Splat>
class BatchTracer {
 public:
  /// The first two must outlive it.
  BatchTracer(const SampleSource& source, TraceState& state, const Splat& splat)
      : source_(source), state_(state), splat_(splat) {}

  /// Traces the batch once it is full. As Finish gives whether nobody asked to stop by state.stop, looked at before a
  /// batch, which then is left as it is, and after it, when integrators may have left off.
  bool Add(const PixelSample& sample) {
    if (due_.empty()) due_.reserve(R1::batch_size);  // growing step by step takes longer
    due_.push_back(sample);
    return due_.size() < R1::batch_size || Finish();
  }
  /// Traces what has not been.
  bool Finish() {
    if (state_.IsStopped()) return false;
    samples_.resize(due_.size()), radiances_.resize(due_.size());
    source_.camera.MakeEach(due_, samples_);
    TraceSamples(source_, samples_, radiances_, state_);
    for (std::size_t i = 0; i < due_.size(); ++i)
      splat_(due_[i].column, due_[i].row, samples_[i], source_.clamps_samples ? Clamped(radiances_[i]) : radiances_[i]);
    due_.clear();
    return !state_.IsStopped();
  }
  /// Whether all that was added has been traced.
  bool IsEmpty() const { return due_.empty(); }

 private:
  const SampleSource& source_;
  TraceState& state_;
  const Splat splat_;
  // As long as batches are: a pass may take one sample of a block, and to fill arrays for more took a sixth of its
  // time.
  std::vector<PixelSample> due_;
  std::vector<CameraSample> samples_;
  std::vector<R2::Color> radiances_;
};

/// Which samples of a block are due: from `first` to `last` - 1 of each pixel, of one stream.
struct SamplesDue {
  PixelRectangle pixels;
  int stream = 0;
  std::uint32_t first = 0, last = 0;
  std::span<const R2::Color> first_samples{};  // of sample 0, where they were taken before the others: see Film::Block
};

/// The road of every sample: pixel, camera ray, integrator, film. Adds the samples that are due to `sums`.
///   returns   whether nobody asked to stop by state.stop, looked at before each batch; else `sums` is of no use
bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 BlockSums& sums);

/// Takes sample 0 of the first stream at more places of a block, from looks.size() to `places` - 1 of BlockOrder.
///   returns   as above; `looks` then has `places` colors
bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  std::vector<R2::Color>& looks);

}  // namespace ray
