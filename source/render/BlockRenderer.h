#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "source/film/Film.h"
#include "source/render/SampleTracer.h"

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
  void Trace(TraceState& state, BlockSums& sums);

  SampleTracer tracer_;
  const Filter& filter_;
  const Halt halt_;
};

}  // namespace ray
