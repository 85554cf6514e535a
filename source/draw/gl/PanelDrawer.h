#pragma once

#include <memory>
#include <optional>

#include "source/draw/PanelDrawing.h"
#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Panels over the drawing. Whoever never shows them pays for no program and no texture. Every fragment takes one texel
/// as it is, so that all contexts draw the same bytes.
class PanelDrawer {
 public:
  /// Over all of the canvas, whatever its viewport. Throws ContextError when the driver rejects the shader.
  void Draw(const PanelDrawing& panels, const Canvas& canvas);

 private:
  struct Gpu {
    Gpu();
    void Upload(const InkSheet& sheet);
    ShaderProgram program;
    VertexArray vertex_array;
    Buffer corners, indices;
    Texture2D sheet;
  };

  std::optional<Gpu> gpu_;                 // once there was something to draw
  std::shared_ptr<const InkSheet> sheet_;  // uploaded
};

}  // namespace ray
