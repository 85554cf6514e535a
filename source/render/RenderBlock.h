#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "R1/Columns.h"
#include "source/film/Film.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrator.h"
#include "source/integrate/SharedPaths.h"

namespace ray {

/// Returns the key of all random choices of a pixel. `stream`: 0-based, for independent sample sequences.
inline RandomKey PixelKey(const RandomKey& seed, int column, int row, int stream) {
  const RandomKey key = seed.Child(static_cast<std::uint64_t>(column)).Child(static_cast<std::uint64_t>(row));
  // CameraRays uses the children below 2, RenderTogether the last one.
  return stream == 0 ? key : key.Child(1 + static_cast<std::uint64_t>(stream));
}

/// The source of an image's samples.
struct SampleSource {
  const Integrator& integrator;
  const CameraRays& camera;
  RandomKey seed;
  bool clamps_samples = false;

  RandomKey PixelKey(int column, int row, int stream = 0) const { return ray::PixelKey(seed, column, row, stream); }
  /// Returns the first sample of the first stream.
  PixelSample FirstSample(int column, int row) const { return {column, row, PixelKey(column, row), 0}; }
};

/// Computes the radiances of some samples, black for those without a ray.
void TraceSamples(const SampleSource& source, std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                  TraceState& state);

/// Samples of pixels that are traced together, at most R1::batch_size, which is faster in integrators than one at a
/// time. Reuse one for many batches: creating its arrays each time took a twelfth of the time of a fast frame.
struct SampleBatch {
  std::vector<PixelSample> due;
  std::vector<CameraSample> samples;  // of each element of `due`, after tracing; there may be more
  std::vector<R2::Color> radiances;   // clamped, if the source says so
  SharedPaths shared;

  void Clear() { due.clear(), due.reserve(R1::batch_size); }  // growing step by step takes longer
};

/// Traces the samples that are due. The radiance of a ray depends on its pixel, stream and index alone, not on other
/// rays in its batch or before it; except in the modes that show costs, where an accelerator remembers the last hit.
///   returns   false after a stop request in state.stop: either before, with nothing traced, or during tracing, when
///             integrators may have returned early
bool Trace(const SampleSource& source, TraceState& state, SampleBatch& batch);

/// The samples of a block that are due: `first` to `last` - 1 of each pixel, of one stream.
struct SamplesDue {
  PixelRectangle pixels;
  int stream = 0;
  std::uint32_t first = 0, last = 0;
  // of sample 0, if they were taken before the others: see Film::Block
  std::span<const R2::Color> first_samples{};
};

/// Takes samples: from pixel to camera ray, integrator and film. Adds the samples that are due to `sums`. Uses only the
/// memory of `batch`.
///   returns   false after a stop request in state.stop, which is checked before each batch; `sums` is then unspecified
bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 SampleBatch& batch, BlockSums& sums);

/// Takes the samples with one index, of one stream, of all pixels in a square of blocks, whose paths share light. Adds
/// them to `sums`, one for each block.
///   returns   as RenderBlock
bool RenderTogether(const SampleSource& source, std::span<const PixelRectangle> blocks, int stream, std::uint32_t index,
                    const Filter& filter, TraceState& state, SampleBatch& batch, std::span<BlockSums* const> sums);

/// Takes sample 0 of the first stream at more places of a block, from looks.size() to `places` - 1 of BlockOrder. Uses
/// only the memory of `batch`.
///   returns   false after a stop request, as RenderBlock does; otherwise `looks` has `places` colors
bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  SampleBatch& batch, std::vector<R2::Color>& looks);

}  // namespace ray
