#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <vector>

#include "source/film/Film.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrator.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// When to leave off: when asked to, at once; or at a time, at the next state that can be kept.
struct Halt {
  using Clock = std::chrono::steady_clock;
  const std::atomic<bool>* stop = nullptr;  // may be null
  std::optional<Clock::time_point> pause_at{};

  bool IsAsked() const { return stop && stop->load(std::memory_order_relaxed); }
  bool IsPauseDue() const { return pause_at && Clock::now() >= *pause_at; }
};

/// Takes samples of the pixels of one block.
class BlockRenderer {
 public:
  BlockRenderer(const Integrator& integrator, const CameraRays& camera, const Filter& filter,
                const RenderSettings& settings, const Halt& halt);

  /// Samples first to last - 1 of each pixel, of one stream, added to `sums` pixel by pixel. Whether nobody asked
  /// to stop; else `sums` is of no use.
  bool Render(const PixelRectangle& pixels, int stream, std::uint32_t first, std::uint32_t last, TraceState& state,
              BlockSums& sums);

 private:
  /// Which pixel a sample was taken of.
  struct Place {
    int column, row;
  };
  void Trace(TraceState& state, BlockSums& sums);

  const Integrator& integrator_;
  const CameraRays& camera_;
  const Filter& filter_;
  const RandomKey seed_;
  const bool is_heat_;
  const Halt halt_;
  std::vector<CameraSample> samples_;
  std::vector<Place> places_;
  std::vector<R2::Color> radiances_;
};

}  // namespace ray
