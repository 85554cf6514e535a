#pragma once

#include <array>
#include <memory>
#include <span>

#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"
#include "source/draw/preview/PreviewView.h"

namespace ray {

/// The display of an image. Each channel is multiplied by `exposure`, then clamped, encoded as sRGB if `srgb` is set,
/// and rounded to the byte of an image file. Rows at and above `rows` are omitted. With alpha below 1, later drawing is
/// not hidden.
struct ImageLook {
  double exposure = 1;
  bool srgb = false;
  bool truncated = false;  // to bytes, as in R2::Quantization
  int rows = -1;           // -1: all
  double alpha = 1;
};

/// Draws images of floats on quads.
class ImageDrawer {
 public:
  ImageDrawer();

  /// Creates a black image of floats r g b; width and height at least 1. Throws ContextError if the GPU cannot store
  /// one of that size.
  std::shared_ptr<GpuImage> Make(int width, int height) const;
  /// Updates rows first .. first + count - 1 from the bottom; `rgb` contains these rows.
  void Update(GpuImage& image, int first, int count, std::span<const float> rgb) const;

  /// Draws an image on a quad in space, given by its lower left, lower right, upper right and upper left corner.
  void Draw(const GpuImage& image, const std::array<std::array<float, 3>, 4>& corners,
            const ClipMatrix& clip_from_drawing, const ImageLook& look) const;
  /// Draws an image over everything else, without depth; its corners, in that order, are in the square from -1 to 1
  /// that is the viewport.
  void DrawFlat(const GpuImage& image, const std::array<std::array<float, 3>, 4>& corners, const ImageLook& look) const;
  /// Writes only the depths of an image of distances from the eye over the viewport; 0 is infinitely far.
  ///   unit   the length of 1 in the drawing space, in units of the distances
  void DrawDepths(const GpuImage& distances, const PreviewView& view, const ClipMatrix& clip_from_drawing,
                  double unit) const;
  /// Draws an image over the whole viewport.
  void Draw(const GpuImage& image, const ImageLook& look) const;

 private:
  ShaderProgram program_;
  mutable std::unique_ptr<ShaderProgram> depths_;  // created on first use
  VertexArray nothing_;                            // the corners are uniforms
  Texture2D steps_;                                // where bytes begin: a row for linear, sRGB, and both truncated
};

}  // namespace ray
