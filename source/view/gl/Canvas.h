#pragma once

#include <memory>
#include <optional>

#include "R2/Image.h"
#include "source/view/gl/Objects.h"
#include "source/view/gl/Painter.h"

namespace ray {

/// What is drawn into: framebuffer 0, or one of its own of whatever size is asked for.
class Canvas {
 public:
  explicit Canvas(Painter::Target target);

  /// Throws ContextError when one of its own cannot be that large.
  void Begin(int width, int height, const R2::Color& background);
  void Fill(const R2::Color& color) const;
  void SetPart(int x, int y, int width, int height);
  /// From here on, and back: the whole of it instead of the part.
  void LeavePart() const { Apply({0, 0, width_, height_}); }
  void ReturnToPart() const { Apply(part_); }
  R2::Image Read() const;

  int Width() const { return width_; }
  int Height() const { return height_; }

 private:
  struct Own {
    Framebuffer framebuffer;
    Renderbuffer color, depth;
    int width = 0, height = 0;
  };
  struct Part {
    int x = 0, y = 0, width = 0, height = 0;
  };

  void Resize(Own& own, int width, int height) const;
  void Apply(const Part& part) const;

  std::optional<Own> own_;
  int width_ = 0, height_ = 0;
  Part part_;
};

}  // namespace ray
