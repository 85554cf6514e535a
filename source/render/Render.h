#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "R2/Image.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/integrate/RayCounts.h"
#include "source/integrate/TraceSettings.h"

namespace ray {

/// A rectangle of pixels: columns x0 <= x < x1 from the left, rows y0 <= y < y1 from the BOTTOM.
struct PixelRectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::int64_t Area() const { return static_cast<std::int64_t>(x1 - x0) * (y1 - y0); }
};

/// whitted: what the camera sees. heat: what each pixel cost to trace, as HeatColor shows it.
inline constexpr std::array render_modes{"whitted", "heat"};

/// What picture to make of a scene, and how the work is spread; the latter never changes a bit of the former.
struct RenderSettings {
  int width = 256, height = 256;       // of the whole picture
  std::optional<PixelRectangle> crop;  // the part that is rendered; its pixels equal those of the whole
  int samples = 1;                     // camera rays a pixel, >= 1
  std::uint64_t seed = 0;
  std::string mode = "whitted";        // one of render_modes
  TraceSettings trace;

  int threads = 0;     // 0: as many as the machine has
  int tile_size = 32;  // side of a work item in pixels, >= 1; 0: the whole picture is one
};

/// How far a render has come.
struct RenderProgress {
  std::int64_t pixels_done = 0, pixels_total = 0;
  std::uint64_t rays = 0;  // of all kinds, so far
};

/// What a render needs from whoever asked for it.
struct RenderMonitor {
  const std::atomic<bool>* stop = nullptr;               // looked at before each pixel; may be null
  std::function<void(const RenderProgress&)> tile_done;  // called from any thread, one at a time; may be empty
};

/// What a render gives.
struct RenderResult {
  R2::Image image;  // of the crop, or of the whole; black where nothing was rendered yet
  std::int64_t pixels_done = 0, pixels_total = 0;
  RayCounts rays;

  bool IsComplete() const { return pixels_done == pixels_total; }
};

/// About how many rays a render will trace: what is known before it.
double ExpectedRays(const RenderSettings& settings);

/// Renders the world through its scene's camera. The image is the same, bit for bit, for any thread count and tile
/// size.
RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor = {});

}  // namespace ray
