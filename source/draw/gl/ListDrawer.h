#pragma once

#include <memory>

#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Draws lines in the colors of their vertices.
class ListDrawer {
 public:
  ListDrawer();

  /// Uploads lines, which stay on the GPU while the pointer exists. Throws ContextError if its memory is full.
  std::shared_ptr<GpuLines> Upload(const Lines& lines) const;

  /// Draws lines of `width` pixels, or of the GPU's maximum width. Where they are behind earlier drawing, above all
  /// triangles, their alpha is multiplied by `hidden`, in [0, 1].
  void Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width = 1, double hidden = 0) const;

 private:
  void Start(const ClipMatrix& clip_from_drawing, double alpha) const;

  ShaderProgram program_;
  float widest_ = 1;  // maximum line width in pixels
};

}  // namespace ray
