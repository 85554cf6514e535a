#pragma once

#include <memory>
#include <span>

#include "source/view/gl/Objects.h"
#include "source/view/gl/Program.h"

namespace ray {

/// Labels in our own font. What it draws with stands in Painter.h.
class TextDrawer {
 public:
  TextDrawer();

  /// Into the viewport, which is of this size.
  void Draw(std::span<const Label> labels, int width, int height) const;

 private:
  Program program_;
  VertexArray vertex_array_;
  Buffer vertices_;
  Texture2D sheet_;
};

}  // namespace ray
