#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "R2/Color.h"
#include "source/draw/Frame.h"
#include "source/render/Render.h"
#include "source/render/RenderBlock.h"

namespace ray {

/// The first sample of every pixel of a picture, in an order that soon shows something everywhere: pixels some stride
/// apart, then half of it, down to 1. Each pixel is traced once, and fills the square of the frame up to its neighbors
/// of that pass until these squares are refined.
class CoarsePasses {
 public:
  /// Where it reports its progress; all outlive it, and any thread may look.
  struct Watch {
    Frame& frame;                           // of the part of the picture that is wanted
    const std::atomic<bool>& stop;          // checked before each batch of pixels
    std::atomic<std::uint64_t>& rays;       // traced, of all kinds
    std::atomic<std::int64_t>& begun_late;  // pixels traced in spite of `stop`, which are none; see RenderJob
  };

  /// `film`: an empty one of the settings. `settings.threads` at least 1.
  CoarsePasses(const Integrator& integrator, const CameraRays& camera, const Film& film, const RenderSettings& settings,
               const Watch& watch);

  /// Traces the pixels `stride` apart except those `traced_stride` apart, a multiple or 0, which have been. Whether
  /// nobody asked to stop; throws what a thread threw.
  bool Trace(int stride, int traced_stride);
  std::int64_t PixelsTraced() const { return pixels_traced_.load(); }

  /// All samples as Render would have them after looks at every pixel, given away; once all are traced.
  RenderState TakeState();

 private:
  struct Worker {
    TraceState state;
    std::int64_t pixels_traced = 0, pixels_reported = 0;
    std::uint64_t rays_reported = 0;
  };
  /// Pixels traced one after another by one thread: a rectangle of them `stride` apart.
  struct Item {
    PixelRectangle pixels;
    int stride, traced_stride;
  };

  bool TraceItem(const Item& item, Worker& worker);
  void Report(bool was_stopped_before, Worker& worker);
  void Show(int column, int row, int stride, const R2::Color& radiance);
  std::size_t Index(int column, int row) const {
    return static_cast<std::size_t>(row - sampled_.y0) * static_cast<std::size_t>(sampled_.Width()) +
           static_cast<std::size_t>(column - sampled_.x0);
  }

  const SampleSource source_;
  const Film& film_;
  const Watch watch_;
  const bool is_heat_;
  const PixelRectangle sampled_;  // the pixels of the film
  const int threads_;
  std::vector<R2::Color> colors_;
  tbb::enumerable_thread_specific<Worker> workers_;
  std::atomic<std::int64_t> pixels_traced_ = 0;
};

}  // namespace ray
