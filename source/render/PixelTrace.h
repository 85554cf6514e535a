#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The rays behind a pixel.
struct PixelTrace {
  int column = 0, row = 0;        // from the left, and from the bottom
  std::vector<RecordedRay> rays;  // of all its samples; parents before children
  std::vector<CameraSample> samples;
  std::vector<R2::Color> radiances;  // what each sample saw
  bool clamps_samples = false;       // before they count, see Clamp

  /// What sample number `i` counts as.
  R2::Color Counted(std::size_t i) const { return clamps_samples ? Clamped(radiances[i]) : radiances[i]; }
  R2::Color Mean() const;
};

/// Traces pixels while keeping their rays: by the same integrator, from the same random choices as Render does, so
/// these are the rays of the picture.
class PixelTracer {
 public:
  /// All must outlive it.
  PixelTracer(const World& world, const Accelerator& accelerator, const RenderSettings& settings);

  /// The first `samples` samples of a pixel of the whole picture; where it has two streams, of each in turn.
  PixelTrace Trace(int column, int row, int samples) const;

 private:
  RandomKey seed_;
  bool clamps_samples_;
  int streams_;
  std::unique_ptr<const Integrator> integrator_;
  CameraRays camera_;
};

/// How numbers are written: with five digits, or so that they read back as the same to the bit.
enum class Digits { five, all };

inline constexpr std::size_t most_rays_of_tree = 1000;

/// The tree of a pixel's rays in lines of text: kind, origin, direction, where each ends and on what, its
/// throughput and what it contributes. At most `most_rays` of them, then a count of the rest.
std::string RayTree(const PixelTrace& trace, const World& world, const RenderSettings& settings,
                    std::size_t most_rays = most_rays_of_tree, Digits digits = Digits::five);

/// Traces all samples of a pixel of the whole image. If an error or a time ends the render, these are the most it may
/// take.
PixelTrace TracePixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                      int row);

/// Describes all samples of one pixel to the user. If an error or a time ends the render, these are the most it may
/// take.
std::string DebugPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                       int row, Digits digits = Digits::five);

}  // namespace ray
