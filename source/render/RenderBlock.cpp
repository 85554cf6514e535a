#include "source/render/RenderBlock.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>

namespace ray {
namespace {

std::size_t PlaceOf(int column, int row) { return static_cast<std::size_t>(BlockOrder::PlaceOf(column, row)); }

/// Traces at most one batch of first samples, and stores them by the places of their pixels.
bool TraceLooks(const SampleSource& source, TraceState& state, SampleBatch& batch, std::span<R2::Color> looks) {
  static_assert(BlockOrder::places <= R1::batch_size);
  if (!Trace(source, state, batch)) return false;
  for (std::size_t i = 0; i < batch.due.size(); ++i)
    looks[PlaceOf(batch.due[i].column, batch.due[i].row)] = batch.radiances[i];
  return true;
}

template <class Function>
void ForPixels(const PixelRectangle& pixels, const Function& function) {
  for (int row = pixels.y0; row < pixels.y1; ++row)
    for (int column = pixels.x0; column < pixels.x1; ++column) function(column, row);
}

/// Adds samples of which some are known, in the usual order.
bool RenderAroundFirstSamples(const SampleSource& source, const SamplesDue& due, const Filter& filter,
                              TraceState& state, SampleBatch& batch, BlockSums& sums) {
  assert(due.stream == 0 && due.first == 0 && due.last == 1);
  std::array<R2::Color, BlockOrder::places> all;
  std::ranges::copy(due.first_samples, all.begin());
  batch.Clear();
  ForPixels(due.pixels, [&](int column, int row) {
    if (PlaceOf(column, row) < due.first_samples.size()) return;
    const PixelSample sample = source.FirstSample(column, row);  // named, so that push_back is inlined
    batch.due.push_back(sample);
  });
  if (!TraceLooks(source, state, batch, all)) return false;
  if (filter.IsBox()) {  // whose weights are independent of the place in the pixel
    ForPixels(due.pixels,
              [&](int column, int row) { sums.Add(column, row, column, row, all[PlaceOf(column, row)], filter); });
    return true;
  }
  std::vector<PixelSample> of;
  ForPixels(due.pixels, [&](int column, int row) { of.push_back(source.FirstSample(column, row)); });
  std::vector<CameraSample> samples(of.size());
  source.camera.MakeEach(of, samples);
  for (std::size_t i = 0; i < of.size(); ++i)
    sums.Add(of[i].column, of[i].row, samples[i].x, samples[i].y, all[PlaceOf(of[i].column, of[i].row)], filter);
  return true;
}

}  // namespace

void TraceSamples(const SampleSource& source, std::span<const CameraSample> samples, std::span<R2::Color> radiances,
                  TraceState& state) {
  const auto trace = [&](std::span<const CameraSample> of, std::span<R2::Color> into) {
    source.integrator.Li(of, into, state);
    if (state.shared) source.integrator.AddShared(into, state);
  };
  if (source.camera.SeesEverywhere()) return trace(samples, radiances);
  std::vector<CameraSample> seen;
  std::ranges::copy_if(samples, std::back_inserter(seen), &CameraSample::HasRay);
  std::vector<R2::Color> of_seen(seen.size());
  if (!seen.empty()) trace(seen, of_seen);
  auto next = of_seen.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) radiances[i] = samples[i].HasRay() ? *next++ : R2::Color{};
}

bool Trace(const SampleSource& source, TraceState& state, SampleBatch& batch) {
  if (state.IsStopped()) return false;
  const std::size_t count = batch.due.size();
  if (batch.samples.size() < count) batch.samples.resize(count), batch.radiances.resize(count);
  const auto samples = std::span(batch.samples).first(count);
  const auto radiances = std::span(batch.radiances).first(count);
  source.camera.MakeEach(batch.due, samples);
  TraceSamples(source, samples, radiances, state);
  if (source.clamps_samples)
    for (R2::Color& radiance : radiances) radiance = Clamped(radiance);
  return !state.IsStopped();
}

bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  SampleBatch& batch, std::vector<R2::Color>& looks) {
  std::array<R2::Color, BlockOrder::places> all;
  std::ranges::copy(looks, all.begin());
  batch.Clear();
  for (int place = static_cast<int>(looks.size()); place < places; ++place) {
    const auto [column, row] = BlockOrder::PixelAt(place, pixels);
    if (pixels.Contains(column, row)) batch.due.push_back(source.FirstSample(column, row));
  }
  if (!TraceLooks(source, state, batch, all)) return false;
  looks.assign(all.begin(), all.begin() + places);
  return true;
}

bool RenderTogether(const SampleSource& source, std::span<const PixelRectangle> blocks, int stream, std::uint32_t index,
                    const Filter& filter, TraceState& state, SampleBatch& batch, std::span<BlockSums* const> sums) {
  constexpr std::uint64_t group_key = ~std::uint64_t{0};
  if (state.IsStopped()) return false;
  batch.due.clear();
  for (const PixelRectangle& pixels : blocks)
    ForPixels(pixels, [&](int column, int row) {
      const PixelSample sample{column, row, source.PixelKey(column, row, stream), index};
      batch.due.push_back(sample);
    });
  const std::span<const PixelSample> due = batch.due;
  batch.samples.resize(std::max(batch.samples.size(), due.size()));
  batch.radiances.resize(std::max(batch.radiances.size(), due.size()));
  const auto samples = std::span(batch.samples).first(due.size());
  const auto radiances = std::span(batch.radiances).first(due.size());
  for (std::size_t first = 0; first < due.size(); first += R1::batch_size) {
    const std::size_t count = std::min(due.size() - first, R1::batch_size);
    source.camera.MakeEach(due.subspan(first, count), samples.subspan(first, count));
  }
  batch.shared.Begin(due.size(), due[0].pixel.Child(group_key).Child(index));
  state.shared = &batch.shared;
  TraceSamples(source, samples, radiances, state);
  state.shared = nullptr;
  if (state.IsStopped()) return false;
  std::size_t i = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block)
    ForPixels(blocks[block], [&](int column, int row) {
      const R2::Color radiance = source.clamps_samples ? Clamped(radiances[i]) : radiances[i];
      // Some pixels are sampled for others alone, and reach none of the film's.
      const PixelRectangle near = Grown({column, row, column + 1, row + 1}, filter.Apron());
      if (Common(sums[block]->Reach(), near).Area() > 0)
        sums[block]->Add(column, row, samples[i].x, samples[i].y, radiance, filter);
      ++i;
    });
  return true;
}

bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 SampleBatch& batch, BlockSums& sums) {
  if (!due.first_samples.empty()) return RenderAroundFirstSamples(source, due, filter, state, batch, sums);
  batch.Clear();
  const auto add_batch = [&source, &state, &sums, &filter, &batch] {
    if (!Trace(source, state, batch)) return false;
    const CameraSample* sample = batch.samples.data();
    const R2::Color* radiance = batch.radiances.data();
    for (const auto& [column, row, key, index] : batch.due)
      sums.Add(column, row, sample->x, sample->y, *radiance, filter), ++sample, ++radiance;
    batch.due.clear();
    return true;
  };
  for (int row = due.pixels.y0; row < due.pixels.y1; ++row)
    for (int column = due.pixels.x0; column < due.pixels.x1; ++column) {
      const RandomKey key = source.PixelKey(column, row, due.stream);
      for (std::uint32_t index = due.first; index < due.last; ++index) {
        const PixelSample sample{column, row, key, index};  // named, so that push_back is inlined
        batch.due.push_back(sample);
        if (batch.due.size() == R1::batch_size && !add_batch()) return false;
      }
    }
  return batch.due.empty() || add_batch();
}

}  // namespace ray
