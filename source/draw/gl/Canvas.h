#pragma once

#include <epoxy/gl.h>

#include <array>
#include <optional>

#include "R2/Image.h"
#include "source/draw/gl/Objects.h"

namespace ray {

/// A framebuffer with what it needs, and its size in pixels.
struct OffscreenTarget {
  Framebuffer framebuffer;
  Renderbuffer color, depth;
  int width = 0, height = 0;
};

/// From here on colors are blended over what is there by their alpha, if GL_BLEND is enabled.
void UseAlpha();

/// What is drawn into: framebuffer 0 of a window, or a framebuffer of its own, of whatever size is asked for.
class Canvas {
 public:
  enum class Target { window, own };
  explicit Canvas(Target target);

  /// A new drawing of this size, at least 0 each; the viewport is all of it. To be called before anything is drawn.
  /// Throws ContextError when a framebuffer cannot be so large.
  void Begin(int width, int height, const R2::Color& background);
  /// The viewport in one color, with nothing in it any more.
  void Fill(const R2::Color& color) const;
  /// What follows is drawn there, and clipped to it.
  void SetViewport(int x, int y, int width, int height);
  /// What follows is clipped to that rectangle, until the next viewport.
  void Clip(int x, int y, int width, int height) const { glScissor(x, y, width, height); }
  /// From here on, and back: all of the drawing instead of the viewport.
  void UseWhole() const { Apply({0, 0, width_, height_}); }
  void UseViewport() const { Apply(viewport_); }
  /// The drawing so far, at least one pixel of it; each channel a byte / 255. In a window before it is shown.
  R2::Image Read() const;

  /// Waits until all of the drawing is done.
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

/// Saves what is being drawn into and the viewport, and restores both at its end.
class KeptTarget {
 public:
  KeptTarget();
  ~KeptTarget();
  KeptTarget(const KeptTarget&) = delete;
  KeptTarget& operator=(const KeptTarget&) = delete;

  /// x, y, width, height
  const std::array<GLint, 4>& Viewport() const { return viewport_; }

 private:
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{}, clip_{};
};

/// Whether the current target encodes in sRGB itself, so that blending is done in linear light.
bool CanEncodeSrgb();

}  // namespace ray
