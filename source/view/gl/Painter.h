#pragma once

#include <memory>
#include <optional>
#include <span>

#include "R2/Image.h"
#include "source/view/Drawing.h"
#include "source/view/contexts/Context.h"

namespace ray {

/// What a list is kept as by OpenGL; of the painter that made it.
struct GpuTriangles;
struct GpuLines;
struct GpuPicture;

/// Draws lists with OpenGL 3.3 core. All calls on the thread of the context, which must be current and outlive the
/// painter and all that it keeps.
class Painter {
 public:
  /// Where the drawing goes: framebuffer 0 of a window, or one of its own. Throws ContextError when the driver refuses
  /// a shader.
  enum class Target { window, own };
  explicit Painter(Target target);
  ~Painter();
  Painter(const Painter&) = delete;

  /// GpuCache until the pointer goes. Throws ContextError when the graphics have no memory left.
  std::shared_ptr<GpuTriangles> Keep(const Triangles& triangles);
  std::shared_ptr<GpuLines> Keep(const Lines& lines);
  /// A black picture, of floats r g b; width and height at least 1. Throws ContextError when the graphics cannot keep
  /// one so large.
  std::shared_ptr<GpuPicture> KeepPicture(int width, int height);
  /// Rows first .. first + count - 1 from the bottom; `rgb` holds those rows.
  void Update(GpuPicture& picture, int first, int count, std::span<const float> rgb);
  /// What is kept, for tests: rows from the bottom, r g b.
  std::vector<float> ReadBack(const GpuPicture& picture);

  /// A new drawing of this size, at least 0 each; its part is the whole. To be called before anything else draws.
  /// Throws ContextError when a framebuffer cannot be so large.
  void Begin(int width, int height, const R2::Color& background);
  /// What follows goes to a part of the drawing, and is cut there.
  void SetPart(int x, int y, int width, int height);
  /// All of the part in one colour, with nothing in it any more.
  void Fill(const R2::Color& color);
  /// Opaque ones first, then clear ones without writing depth.
  void Draw(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing);
  /// Lines of `width` pixels, or as wide as the graphics allow; what is hidden by what was drawn before, triangles
  /// above all, is drawn with its cover times `hidden`, in [0, 1].
  void Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width = 1, double hidden = 0);
  /// Edges of triangles in one colour.
  void DrawEdges(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing, const Rgba& color);
  /// The picture on a quad in space: its lower left, lower right, upper right and upper left corner. Each channel is
  /// multiplied by `exposure`, then clamped, encoded as sRGB if asked for, and made the byte an image file would hold.
  /// Rows at and above `rows` are left out. One with alpha below 1 hides nothing drawn later.
  struct PictureLook {
    double exposure = 1;
    bool srgb = false;
    int rows = -1;  // -1: all
    double alpha = 1;
  };
  void Draw(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
            const ClipMatrix& clip_from_drawing, const PictureLook& look);
  /// The picture over the current part, from corner to corner.
  void Draw(const GpuPicture& picture, const PictureLook& look);
  /// Text over all, on a dark ground so that it can be read on anything. 8 x 16 pixels a character.
  void Draw(std::span<const Label> labels);

  /// Waits until all of the drawing is done, for those who measure.
  void Finish();
  /// The drawing so far, at least one pixel of it; each channel a byte / 255. In a window before it is shown.
  R2::Image Read();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ray
