#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/inspect/DebugRays.h"
#include "source/inspect/ForeignRays.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// The rays a user looks at: those of a grid of pixels, and those of one pixel. They stay where they are while the
/// camera moves on.
class RayInspector {
 public:
  /// The grid of an image; its settings say from where.
  void TraceGrid(const LoadedScene& scene, const RenderSettings& settings);
  /// One pixel, inside of the image.
  void TracePixel(const LoadedScene& scene, const RenderSettings& settings, int column, int row);
  /// The pixel next to it, in the same image; false at the border, or when there is none.
  bool StepPixel(const LoadedScene& scene, int right, int up);
  /// Traces the pixel again, if there is one, with the counts as they are now.
  void TraceAgain(const LoadedScene& scene);
  /// Sets the counts of what is traced from now on.
  void SetCounts(const DebugRayCounts& counts) { counts_ = counts; }
  const DebugRayCounts& Counts() const { return counts_; }
  /// Returns the share of the samples, and of the shadow rays to a light, that are traced, as the end of a message;
  /// empty where they are all.
  std::string WhatIsLeftOut() const;
  /// Shows more or fewer bounces.
  void StepBounce(int by);
  void Toggle(ShownRays kind) { look_.shows[static_cast<std::size_t>(kind)] ^= true; }
  void ToggleNormals() { look_.normals = !look_.normals; }
  void ToggleGrid() { shows_grid_ = !shows_grid_; }
  void ForgetPixel() { pixel_.reset(), look_.chosen.reset(), difference_.reset(); }
  /// One of the pixel's rays, by its number; nothing for none.
  void Choose(std::optional<std::size_t> ray) { look_.chosen = ray; }
  /// Forgets all rays, for another scene.
  void ForgetAll();

  /// Rays of another tracer, to be shown with ours from now on, and compared with those of each pixel that is traced.
  void SetForeign(std::vector<ForeignRay> rays) { foreign_ = std::move(rays); }
  const std::vector<ForeignRay>& Foreign() const { return foreign_; }
  /// The first of them that differs from ours of the pixel; nothing where none does, or there are no rays.
  const std::optional<RayDifference>& Difference() const { return difference_; }

  bool ShowsGrid() const { return shows_grid_; }
  const RayLook& Look() const { return look_; }
  const std::vector<PixelTrace>& Grid() const { return grid_; }
  const std::optional<PixelTrace>& Pixel() const { return pixel_; }
  /// Another for each pixel traced, from 1.
  int TraceNumber() const { return trace_number_; }
  /// The settings of the image that the pixel is in.
  const RenderSettings& PixelSettings() const { return pixel_settings_; }
  /// All rays that are shown.
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
