#pragma once

#include <span>

#include "source/view/gl/Canvas.h"
#include "source/view/gl/ShaderProgram.h"

namespace ray {

/// Labels in our own font, 8 x 16 pixels a character, on a dark ground so that they can be read on anything.
class TextDrawer {
 public:
  TextDrawer();

  /// Over all of the canvas, whatever its viewport. `size`: >= 1, how many times as large as said above.
  void Draw(std::span<const Label> labels, const Canvas& canvas, int size = 1) const;

 private:
  ShaderProgram program_;
  VertexArray vertex_array_;
  Buffer vertices_;
  Texture2D sheet_;
};

}  // namespace ray
