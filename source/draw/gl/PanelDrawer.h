#pragma once

#include <memory>
#include <optional>

#include "source/draw/PanelDrawing.h"
#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Draws panels over the drawing. The program and the texture are created on first use. Every fragment takes one texel
/// without filtering, so that all contexts draw the same bytes.
class PanelDrawer {
 public:
  /// Draws panels over the whole canvas, regardless of its viewport. Throws ContextError if the driver rejects the
  /// shader.
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

  std::optional<Gpu> gpu_;                 // created on first use
  std::shared_ptr<const InkSheet> sheet_;  // uploaded
};

}  // namespace ray
