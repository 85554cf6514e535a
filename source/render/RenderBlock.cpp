#include "source/render/RenderBlock.h"

namespace ray {
namespace {

R2::Color Counted(const SampleSource& source, const R2::Color& radiance) {
  return source.clamps_samples ? Clamped(radiance) : radiance;
}

/// Traces sample 0 of pixels of a block for their places.
class Looker {
 public:
  Looker(const SampleSource& source, TraceState& state, std::vector<R2::Color>& looks)
      : source_(source), state_(state), looks_(looks) {}

  /// These give whether nobody asked to stop.
  bool Add(int column, int row) {
    batch_.Add(column, row, source_.camera(column, row, source_.PixelKey(column, row), 0));
    return !batch_.IsFull() || Finish();
  }
  bool Finish() {
    if (state_.IsStopped()) return false;
    batch_.Trace(source_.integrator, state_, [&](int column, int row, const CameraSample&, const R2::Color& radiance) {
      looks_[static_cast<std::size_t>(BlockOrder::PlaceOf(column, row))] = Counted(source_, radiance);
    });
    return !state_.IsStopped();  // or else integrators may have left off
  }

 private:
  const SampleSource& source_;
  TraceState& state_;
  std::vector<R2::Color>& looks_;
  SampleBatch batch_;
};

template <class Function>
void ForPixels(const PixelRectangle& pixels, const Function& function) {
  for (int row = pixels.y0; row < pixels.y1; ++row)
    for (int column = pixels.x0; column < pixels.x1; ++column) function(column, row);
}

/// Samples of which some are known already, added in the order of all others.
bool RenderAroundLooks(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                       BlockSums& sums) {
  const auto place_of = [](int column, int row) { return static_cast<std::size_t>(BlockOrder::PlaceOf(column, row)); };
  std::vector<R2::Color> all(due.first_looks.begin(), due.first_looks.end());
  all.resize(BlockOrder::places);
  Looker looker(source, state, all);
  bool goes_on = true;
  ForPixels(due.pixels, [&](int column, int row) {
    if (goes_on && place_of(column, row) >= due.first_looks.size()) goes_on = looker.Add(column, row);
  });
  if (!goes_on || !looker.Finish()) return false;
  ForPixels(due.pixels, [&](int column, int row) {
    // Where a sample is in its pixel makes no difference to the box filter.
    const CameraSample sample =
        filter.IsBox() ? CameraSample{} : source.camera(column, row, source.PixelKey(column, row), 0);
    sums.Add(column, row, sample.x, sample.y, all[place_of(column, row)], filter);
  });
  return true;
}

}  // namespace

bool LookAtPlaces(const SampleSource& source, const PixelRectangle& pixels, int places, TraceState& state,
                  std::vector<R2::Color>& looks) {
  std::vector<R2::Color> all = looks;
  all.resize(static_cast<std::size_t>(places));
  Looker looker(source, state, all);
  for (int place = static_cast<int>(looks.size()); place < places; ++place) {
    const auto [column, row] = BlockOrder::PixelAt(place, pixels);
    if (pixels.Contains(column, row) && !looker.Add(column, row)) return false;
  }
  if (!looker.Finish()) return false;
  looks = std::move(all);
  return true;
}

bool RenderBlock(const SampleSource& source, const SamplesDue& due, const Filter& filter, TraceState& state,
                 BlockSums& sums) {
  if (!due.first_looks.empty()) return RenderAroundLooks(source, due, filter, state, sums);
  SampleBatch batch;
  const auto trace_and_splat = [&] {
    if (state.IsStopped()) return false;
    batch.Trace(source.integrator, state,
                [&](int column, int row, const CameraSample& sample, const R2::Color& radiance) {
                  sums.Add(column, row, sample.x, sample.y, Counted(source, radiance), filter);
                });
    return !state.IsStopped();  // or else integrators may have left off
  };
  for (int row = due.pixels.y0; row < due.pixels.y1; ++row)
    for (int column = due.pixels.x0; column < due.pixels.x1; ++column) {
      const RandomKey key = source.PixelKey(column, row, due.stream);
      for (std::uint32_t index = due.first; index < due.last; ++index) {
        batch.Add(column, row, source.camera(column, row, key, index));
        if (batch.IsFull() && !trace_and_splat()) return false;
      }
    }
  return trace_and_splat();
}

}  // namespace ray
