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

/// The radiances of some samples, black for those without a ray.
void TraceSamples(const SampleSource& source, std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                  TraceState& state);

/// Samples of pixels that are traced together, which integrators do faster than one by one; R1::batch_size at most.
/// Whoever traces batch after batch keeps one: to make its arrays anew took a twelfth of the time of a fast frame.
struct SampleBatch {
  std::vector<PixelSample> due;
  std::vector<CameraSample> samples;  // of each, once it is traced; there may be more
  std::vector<R2::Color> radiances;   // clamped, where the source says so

  void Clear() { due.clear(), due.reserve(R1::batch_size); }  // growing step by step takes longer
};

/// Traces the samples that are due. What a ray brings back depends on its pixel, stream and index alone, never on which
/// others are in its batch or came before it; except in the modes that show costs, where an accelerator remembers the
/// last hit.
///   returns   false if state.stop asked to stop: before, when nothing is traced, or meanwhile, when integrators may
///             have broken off
bool Trace(const SampleSource& source, TraceState& state, SampleBatch& batch);

/// Which samples of a block are due: from `first` to `last` - 1 of each pixel, of one stream.
struct SamplesDue {
  PixelRectangle pixels;
  int stream = 0;
  std::uint32_t first = 0, last = 0;
  std::span<const R2::Color> first_samples{};  // of sample 0, where they were taken before the others: see Film::Block
};

/// The road of every sample: pixel, camera ray, integrator, film. Adds the samples that are due to `sums`. Of `batch`
/// only the memory is used.
///   returns   false if state.stop, looked at before each batch, asked to stop; `sums` is of no use then
bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 SampleBatch& batch, BlockSums& sums);

/// Takes sample 0 of the first stream at more places of a block, from looks.size() to `places` - 1 of BlockOrder. Of
/// `batch` only the memory is used.
///   returns   false if asked to stop, as RenderBlock does; otherwise `looks` has `places` colors
bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  SampleBatch& batch, std::vector<R2::Color>& looks);

}  // namespace ray
