#pragma once

#include <cstdint>
#include <vector>

#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// Takes samples of pixels, some neighbours together. What a sample brings back depends on its pixel, stream and index
/// alone, never on which others are taken with it or before it; but for heat, where an accelerator remembers the last
/// hit.
class SampleTracer {
 public:
  SampleTracer(const Integrator& integrator, const CameraRays& camera, const RenderSettings& settings);

  /// Of a pixel's random choices. `stream`: 0 or 1, two independent sets of points.
  RandomKey KeyOf(int column, int row, int stream) const {
    const RandomKey own = seed_.Child(static_cast<std::uint64_t>(column)).Child(static_cast<std::uint64_t>(row));
    return stream == 0 ? own : own.Child(second_stream);
  }
  /// Lays sample `index` of a pixel, whose key is `pixel`, to those that are traced next.
  void Add(int column, int row, const RandomKey& pixel, std::uint32_t index) {
    samples_.push_back(camera_(column, row, pixel, index));
    places_.push_back({column, row});
  }
  /// Whether there are enough to be traced.
  bool IsFull() const { return samples_.size() >= together_; }
  int Size() const { return static_cast<int>(samples_.size()); }
  void Clear() { samples_.clear(), places_.clear(); }

  /// Traces those laid together, and gives each to take(column, row, sample, radiance), in their order.
  template <typename Take>
  void Trace(TraceState& state, const Take& take) {
    FindRadiances(state);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      take(places_[i].column, places_[i].row, samples_[i], radiances_[i]);
    Clear();
  }

 private:
  // What the children of a pixel's key are for, besides those that CameraRays uses.
  static constexpr std::uint64_t second_stream = 2;

  /// Which pixel a sample is taken of.
  struct Place {
    int column, row;
  };
  void FindRadiances(TraceState& state);
  double CostSoFar(const TraceState& state) const;

  const Integrator& integrator_;
  const CameraRays& camera_;
  const RandomKey seed_;
  const bool shows_costs_, counts_rays_;
  const std::size_t together_;
  std::vector<CameraSample> samples_;
  std::vector<Place> places_;
  std::vector<R2::Color> radiances_;
};

}  // namespace ray
