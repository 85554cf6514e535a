#pragma once

#include <memory>

#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Lines in the colors of their vertices.
class ListDrawer {
 public:
  ListDrawer();

  /// On the GPU until the pointer goes. Throws ContextError when its memory is full.
  std::shared_ptr<GpuLines> Upload(const Lines& lines) const;

  /// Lines of `width` pixels, or as wide as the GPU allows. What is behind something drawn before, triangles above all,
  /// is drawn with its alpha times `hidden`, in [0, 1].
  void Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width = 1, double hidden = 0) const;

 private:
  void Start(const ClipMatrix& clip_from_drawing, double alpha) const;

  ShaderProgram program_;
  float widest_ = 1;  // line, in pixels
};

}  // namespace ray
