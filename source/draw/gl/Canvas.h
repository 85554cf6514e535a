#pragma once

#include <epoxy/gl.h>

#include <array>
#include <optional>

#include "R2/Image.h"
#include "source/draw/gl/Objects.h"

namespace ray {

/// A framebuffer with its attachments and its size in pixels.
struct OffscreenTarget {
  Framebuffer framebuffer;
  Renderbuffer color, depth;
  int width = 0, height = 0;
};

/// Sets blending of further colors by their alpha, if GL_BLEND is enabled.
void UseAlpha();

/// The target of drawing: framebuffer 0 of a window, or a separate framebuffer of any size.
class Canvas {
 public:
  enum class Target { window, own };
  explicit Canvas(Target target);

  /// Begins a drawing of this size, at least 0 each; the viewport is the whole drawing. Call it before anything is
  /// drawn. Throws ContextError if a framebuffer cannot be that large.
  void Begin(int width, int height, const R2::Color& background);
  /// Clears the viewport to one color.
  void Fill(const R2::Color& color) const;
  /// Restricts further drawing to a viewport.
  void SetViewport(int x, int y, int width, int height);
  /// Clips further drawing to that rectangle, until the next viewport.
  void Clip(int x, int y, int width, int height) const { glScissor(x, y, width, height); }
  /// Restores the whole drawing as the viewport.
  void UseWhole() const { Apply({0, 0, width_, height_}); }
  void UseViewport() const { Apply(viewport_); }
  /// Returns the drawing so far, at least one pixel of it; each channel is a byte / 255. In a window, call it before
  /// Show.
  R2::Image Read() const;

  /// Waits until the drawing is complete.
  static void Finish() { glFinish(); }

  int Width() const { return width_; }
  int Height() const { return height_; }

 private:
  struct Viewport {
    int x = 0, y = 0, width = 0, height = 0;
  };

  void Resize(OffscreenTarget& own, int width, int height) const;
  void Apply(const Viewport& viewport) const;

  std::optional<OffscreenTarget> own_;
  int width_ = 0, height_ = 0;
  Viewport viewport_;
};

/// Saves the target and the viewport, and restores both at its end.
class KeptTarget {
 public:
  KeptTarget();
  ~KeptTarget();
  KeptTarget(const KeptTarget&) = delete;
  KeptTarget& operator=(const KeptTarget&) = delete;

  /// The viewport: x, y, width, height.
  const std::array<GLint, 4>& Viewport() const { return viewport_; }

 private:
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{}, clip_{};
};

/// Returns true if the current target encodes in sRGB itself, so that blending uses linear light.
bool CanEncodeSrgb();

}  // namespace ray
