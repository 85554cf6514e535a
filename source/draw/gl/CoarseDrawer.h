#pragma once

#include <functional>
#include <memory>

#include "source/draw/gl/Objects.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Draws with fewer pixels and enlarges the result, or with several samples per pixel and averages them. Averaged
/// colors are smooth, while depths are those of one place, so that later drawing is hidden correctly.
class CoarseDrawer {
 public:
  /// Draws with one pixel for step x step of the current viewport, at least 1, and enlarges the result over it. `draw`
  /// fills a whole viewport. Throws ContextError if the driver rejects such a framebuffer or the shader.
  void Draw(int step, const std::function<void()>& draw) const;
  /// Draws with samples_of_smooth per pixel, or as many as the driver supports, which may be one. `draw` fills the
  /// whole current viewport.
  void DrawSmoothly(const std::function<void()>& draw) const;
  static constexpr int samples_of_smooth = 4;

 private:
  struct Small {
    Framebuffer framebuffer;
    Texture2D colors, depths;
    int width = 0, height = 0;
    bool is_srgb = false;
  };
  /// The samples of each pixel of a Small.
  struct Samples {
    Framebuffer framebuffer;
    Renderbuffer colors, depths;
    int width = 0, height = 0;
    bool is_srgb = false, is_complete = false;
  };
  void Fit(int width, int height, bool is_srgb) const;
  /// Returns true if the driver accepts the samples.
  bool FitSamples(int width, int height, bool is_srgb) const;
  /// Draws the samples and stores their means in small_. Returns false if the driver cannot.
  bool DrawSamples(const std::function<void()>& draw) const;
  void Enlarge() const;

  // Created on first use.
  mutable std::unique_ptr<Small> small_;
  mutable std::unique_ptr<Samples> samples_;
  mutable std::unique_ptr<ShaderProgram> enlargement_;
  VertexArray nothing_;  // corners are computed from their numbers
};

}  // namespace ray
