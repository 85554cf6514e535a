#pragma once

#include <epoxy/gl.h>

#include <array>

namespace ray {

/// What is being drawn into, and where in it; again so at its end.
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

/// Whether what is drawn into can encode in sRGB itself, and so blend light before.
bool CanEncodeSrgb();

}  // namespace ray
