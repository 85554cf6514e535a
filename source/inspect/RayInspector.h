#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/inspect/DebugRays.h"
#include "source/inspect/ForeignRays.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// The visible rays: those of a grid of pixels, and those of one pixel. They stay in place when the camera moves.
class RayInspector {
 public:
  /// Traces the grid of an image with these settings.
  void TraceGrid(const LoadedScene& scene, const RenderSettings& settings);
  /// One pixel, inside of the image.
  void TracePixel(const LoadedScene& scene, const RenderSettings& settings, int column, int row);
  /// Traces a neighboring pixel of the same image; returns false at the border, or if there is none.
  bool StepPixel(const LoadedScene& scene, int right, int up);
  /// Traces the pixel again, if there is one, with the current counts.
  void TraceAgain(const LoadedScene& scene);
  /// Sets the numbers of rays of later traces.
  void SetCounts(const DebugRayCounts& counts) { counts_ = counts; }
  const DebugRayCounts& Counts() const { return counts_; }
  /// Returns the share of the samples, and of the shadow rays to a light, that are traced, as the end of a message;
  /// empty if all are.
  std::string WhatIsLeftOut() const;
  /// Shows more or fewer bounces.
  void StepBounce(int by);
  void Toggle(ShownRays kind) { look_.shows[static_cast<std::size_t>(kind)] ^= true; }
  void ToggleNormals() { look_.normals = !look_.normals; }
  void ToggleGrid() { shows_grid_ = !shows_grid_; }
  void ForgetPixel() { pixel_.reset(), look_.chosen.reset(), difference_.reset(); }
  /// Chooses one of the pixel's rays by its number; std::nullopt for none.
  void Choose(std::optional<std::size_t> ray) { look_.chosen = ray; }
  /// Forgets all rays, for another scene.
  void ForgetAll();

  /// Sets the rays of another tracer, which are shown with ours and compared with those of each traced pixel.
  void SetForeign(std::vector<ForeignRay> rays) { foreign_ = std::move(rays); }
  const std::vector<ForeignRay>& Foreign() const { return foreign_; }
  /// The first of them that differs from ours in the pixel; std::nullopt if none does.
  const std::optional<RayDifference>& Difference() const { return difference_; }

  bool ShowsGrid() const { return shows_grid_; }
  const RayLook& Look() const { return look_; }
  const std::vector<PixelTrace>& Grid() const { return grid_; }
  const std::optional<PixelTrace>& Pixel() const { return pixel_; }
  /// The number of pixels traced so far.
  int TraceNumber() const { return trace_number_; }
  /// The settings of the pixel's image.
  const RenderSettings& PixelSettings() const { return pixel_settings_; }
  /// All visible rays.
  std::vector<PixelTrace> Shown() const;

 private:
  bool shows_grid_ = false;
  RayLook look_;
  std::vector<PixelTrace> grid_;
  std::optional<PixelTrace> pixel_;
  std::vector<ForeignRay> foreign_;
  std::optional<RayDifference> difference_;
  int trace_number_ = 0;
  RenderSettings pixel_settings_;
  DebugRayCounts counts_;
};

}  // namespace ray
