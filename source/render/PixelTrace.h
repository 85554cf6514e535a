#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/integrate/debug/RayRecorder.h"
#include "source/render/RenderSettings.h"

namespace ray {

/// The rays that contribute to a pixel.
struct PixelTrace {
  int column = 0, row = 0;        // from the left, and from the bottom
  std::vector<RecordedRay> rays;  // of all its samples; parents before children
  std::vector<CameraSample> samples;
  std::vector<R2::Color> radiances;  // result of each sample
  bool clamps_samples = false;       // before averaging, see Clamp

  /// Returns the value with which sample number `i` counts.
  R2::Color Counted(std::size_t i) const { return clamps_samples ? Clamped(radiances[i]) : radiances[i]; }
  R2::Color Mean() const;
  /// Returns the children of each ray, in the order in which they were traced.
  std::vector<std::vector<std::size_t>> Children() const;
};

/// Traces pixels and records their rays. Uses the integrator and the random choices of Render, so these are the rays of
/// the image.
class PixelTracer {
 public:
  /// All arguments must outlive it.
  PixelTracer(const World& world, const Accelerator& accelerator, const RenderSettings& settings);

  /// Traces the first `samples` samples of a pixel of the whole image; with two streams, alternating between them.
  PixelTrace Trace(int column, int row, int samples) const;

 private:
  RandomKey seed_;
  bool clamps_samples_;
  int streams_;
  std::unique_ptr<const Integrator> integrator_;
  CameraRays camera_;
};

/// The format of numbers: five digits, or as many as reproduce them exactly.
enum class Digits { five, all };

inline constexpr std::size_t most_rays_of_tree = 1000;

/// Returns the tree of a pixel's rays as lines of text: kind, origin, direction, the end of each and the surface there,
/// its throughput and its contribution. Shows at most `most_rays` rays, then the number of the rest.
std::string RayTree(const PixelTrace& trace, const World& world, const RenderSettings& settings,
                    std::size_t most_rays = most_rays_of_tree, Digits digits = Digits::five);

/// Traces all samples of a pixel of the whole image. If an error or a time limit ends the render, these are the most
/// that it may take.
PixelTrace TracePixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                      int row);

/// Describes all samples of one pixel to the user. If an error or a time limit ends the render, these are the most that
/// it may take.
std::string DebugPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                       int row, Digits digits = Digits::five);

}  // namespace ray
