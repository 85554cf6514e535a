#pragma once

#include <memory>

#include "source/view/gl/Gpu.h"
#include "source/view/gl/Program.h"

namespace ray {

/// Triangles and lines in the colors of their vertices. What it draws with stands in Painter.h.
class ListDrawer {
 public:
  ListDrawer();

  std::shared_ptr<GpuTriangles> Keep(const Triangles& triangles) const;
  std::shared_ptr<GpuLines> Keep(const Lines& lines) const;

  void Draw(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing) const;
  void Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width, double hidden) const;
  void DrawEdges(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing, const Rgba& color) const;

 private:
  void Start(const ClipMatrix& clip_from_drawing, double cover) const;

  Program program_;
  float widest_ = 1;  // line, in pixels
};

}  // namespace ray
