#pragma once

#include <epoxy/gl.h>

#include <array>

namespace ray {

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
