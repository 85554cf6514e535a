#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "source/view/gl/Gpu.h"
#include "source/view/gl/Painter.h"
#include "source/view/gl/Program.h"

namespace ray {

/// Pictures of floats on quads. What it draws with stands in Painter.h.
class PictureDrawer {
 public:
  PictureDrawer();

  std::shared_ptr<GpuPicture> Keep(int width, int height) const;
  void Update(GpuPicture& picture, int first, int count, std::span<const float> rgb) const;
  std::vector<float> ReadBack(const GpuPicture& picture) const;

  void Draw(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
            const ClipMatrix& clip_from_drawing, const Painter::PictureLook& look) const;
  void Draw(const GpuPicture& picture, const Painter::PictureLook& look) const;

 private:
  Program program_;
  VertexArray nothing_;  // the corners come as uniforms
  Texture2D steps_;      // where bytes begin; row 0 linear, row 1 sRGB
};

}  // namespace ray
