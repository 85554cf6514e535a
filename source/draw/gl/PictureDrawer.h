#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"
#include "source/draw/preview/PreviewView.h"

namespace ray {

/// Each channel is multiplied by `exposure`, then clamped, encoded as sRGB if asked for, and made the byte an image
/// file would hold. Rows at and above `rows` are left out. With alpha below 1 it hides nothing drawn later.
struct PictureLook {
  double exposure = 1;
  bool srgb = false;
  bool truncated = false;  // to bytes, as R2::Quantization has it
  int rows = -1;  // -1: all
  double alpha = 1;
};

/// Pictures of floats on quads.
class PictureDrawer {
 public:
  PictureDrawer();

  /// A black picture, of floats r g b; width and height at least 1. Throws ContextError when the GPU cannot hold one so
  /// large.
  std::shared_ptr<GpuPicture> Make(int width, int height) const;
  /// Rows first .. first + count - 1 from the bottom; `rgb` holds those rows.
  void Update(GpuPicture& picture, int first, int count, std::span<const float> rgb) const;

  /// On a quad in space: its lower left, lower right, upper right and upper left corner.
  void Draw(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
            const ClipMatrix& clip_from_drawing, const PictureLook& look) const;
  /// Over all else, without depth: corners as above, in the square from -1 to 1 that is the viewport.
  void DrawFlat(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
                const PictureLook& look) const;
  /// Writes the depth alone of what a picture of distances from the eye shows over the viewport; 0 is endlessly far.
  ///   unit   the length of 1 in the drawing space, in units of the distances
  void DrawDepths(const GpuPicture& distances, const PreviewView& view, const ClipMatrix& clip_from_drawing,
                  double unit) const;
  /// Over the viewport, from corner to corner.
  void Draw(const GpuPicture& picture, const PictureLook& look) const;

 private:
  ShaderProgram program_;
  mutable std::unique_ptr<ShaderProgram> depths_;  // once there are some
  VertexArray nothing_;  // the corners come as uniforms
  Texture2D steps_;      // where bytes begin: a row for linear, sRGB, and both truncated
};

}  // namespace ray
