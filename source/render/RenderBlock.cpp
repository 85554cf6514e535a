#include "source/render/RenderBlock.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace ray {
namespace {

std::size_t PlaceOf(int column, int row) { return static_cast<std::size_t>(BlockOrder::PlaceOf(column, row)); }

/// Keeps samples by the places of their pixels.
auto KeepIn(std::vector<R2::Color>& looks) {
  return [&looks](int column, int row, const CameraSample&, const R2::Color& radiance) {
    looks[PlaceOf(column, row)] = radiance;
  };
}

template <class Function>
void ForPixels(const PixelRectangle& pixels, const Function& function) {
  for (int row = pixels.y0; row < pixels.y1; ++row)
    for (int column = pixels.x0; column < pixels.x1; ++column) function(column, row);
}

/// Samples of which some are known already, added in the order of all others.
bool RenderAroundFirstSamples(const SampleSource& source, const SamplesDue& due, const Filter& filter,
                              TraceState& state, BlockSums& sums) {
  assert(due.stream == 0 && due.first == 0 && due.last == 1);
  std::vector<R2::Color> all(due.first_samples.begin(), due.first_samples.end());
  all.resize(BlockOrder::places);
  BatchTracer tracer(source, state, KeepIn(all));
  bool goes_on = true;
  ForPixels(due.pixels, [&](int column, int row) {
    if (goes_on && PlaceOf(column, row) >= due.first_samples.size())
      goes_on = tracer.Add(source.FirstSample(column, row));
  });
  if (!goes_on || !tracer.Finish()) return false;
  if (filter.IsBox()) {  // to which it makes no difference where a sample is in its pixel
    ForPixels(due.pixels,
              [&](int column, int row) { sums.Add(column, row, column, row, all[PlaceOf(column, row)], filter); });
    return true;
  }
  static_assert(BlockOrder::places <= R1::batch_size);
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
  if (source.camera.SeesEverywhere()) return source.integrator.Li(samples, radiances, state);
  std::vector<CameraSample> seen;
  std::ranges::copy_if(samples, std::back_inserter(seen), &CameraSample::HasRay);
  std::vector<R2::Color> of_seen(seen.size());
  if (!seen.empty()) source.integrator.Li(seen, of_seen, state);
  auto next = of_seen.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) radiances[i] = samples[i].HasRay() ? *next++ : R2::Color{};
}

bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  std::vector<R2::Color>& looks) {
  std::vector<R2::Color> all = looks;
  all.resize(static_cast<std::size_t>(places));
  BatchTracer tracer(source, state, KeepIn(all));
  for (int place = static_cast<int>(looks.size()); place < places; ++place) {
    const auto [column, row] = BlockOrder::PixelAt(place, pixels);
    if (pixels.Contains(column, row) && !tracer.Add(source.FirstSample(column, row))) return false;
  }
  if (!tracer.Finish()) return false;
  looks = std::move(all);
  return true;
}

bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 BlockSums& sums) {
  if (!due.first_samples.empty()) return RenderAroundFirstSamples(source, due, filter, state, sums);
  BatchTracer tracer(source, state, [&](int column, int row, const CameraSample& sample, const R2::Color& radiance) {
    sums.Add(column, row, sample.x, sample.y, radiance, filter);
  });
  for (int row = due.pixels.y0; row < due.pixels.y1; ++row)
    for (int column = due.pixels.x0; column < due.pixels.x1; ++column) {
      const RandomKey key = source.PixelKey(column, row, due.stream);
      for (std::uint32_t index = due.first; index < due.last; ++index)
        if (!tracer.Add({column, row, key, index})) return false;
    }
  return tracer.Finish();
}

}  // namespace ray
