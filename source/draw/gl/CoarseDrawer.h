#pragma once

#include <functional>
#include <memory>

#include "source/draw/gl/Objects.h"
#include "source/draw/gl/ShaderProgram.h"

namespace ray {

/// Draws in fewer pixels than there are, and enlarges that; or with several samples per pixel, and takes their mean.
/// Colors are smooth then, and depths those of one place, so that what is drawn over it is hidden where it should be.
class CoarseDrawer {
 public:
  /// `draw` fills all of a viewport, one pixel for step x step of the present one, at least 1, over which it is then
  /// laid. Throws ContextError when the driver rejects such a framebuffer or the shader.
  void Draw(int step, const std::function<void()>& draw) const;
  /// `draw` fills all of the present viewport, with samples_of_smooth per pixel, or as many as the driver has, which
  /// may be one.
  void DrawSmoothly(const std::function<void()>& draw) const;
  static constexpr int samples_of_smooth = 4;

 private:
  struct Small {
    Framebuffer framebuffer;
    Texture2D colors, depths;
    int width = 0, height = 0;
    bool is_srgb = false;
  };
  /// The samples of each pixel of a Small.
  struct Samples {
    Framebuffer framebuffer;
    Renderbuffer colors, depths;
    int width = 0, height = 0;
    bool is_srgb = false, is_complete = false;
  };
  void Fit(int width, int height, bool is_srgb) const;
  /// Whether the driver accepts them.
  bool FitSamples(int width, int height, bool is_srgb) const;
  /// Whether it drew them, and left their means in small_.
  bool DrawSamples(const std::function<void()>& draw) const;
  void Enlarge() const;

  // Made when they are needed first.
  mutable std::unique_ptr<Small> small_;
  mutable std::unique_ptr<Samples> samples_;
  mutable std::unique_ptr<ShaderProgram> enlargement_;
  VertexArray nothing_;  // corners are made of their numbers
};

}  // namespace ray
