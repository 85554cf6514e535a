#pragma once

#include <functional>
#include <memory>

#include "source/view/gl/Objects.h"
#include "source/view/gl/ShaderProgram.h"

namespace ray {

/// Draws in fewer pixels than there are, and enlarges that: colors smoothly, depths as they are, so that what is drawn
/// over it in full is hidden where it should be.
class CoarseDrawer {
 public:
  /// `draw` fills all of a viewport, one pixel for step x step of the present one, at least 1, over which it is then
  /// laid. Throws ContextError when the driver rejects such a framebuffer or the shader.
  void Draw(int step, const std::function<void()>& draw) const;

 private:
  struct Small {
    Framebuffer framebuffer;
    Texture2D colors, depths;
    int width = 0, height = 0;
    bool is_srgb = false;
  };
  void Fit(int width, int height, bool is_srgb) const;
  void Enlarge() const;

  // Made when they are needed first.
  mutable std::unique_ptr<Small> small_;
  mutable std::unique_ptr<ShaderProgram> enlargement_;
  VertexArray nothing_;  // corners are made of their numbers
};

}  // namespace ray
