#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/draw/CameraMoves.h"
#include "source/draw/Drawing.h"
#include "source/draw/FlatView.h"
#include "source/draw/Frame.h"
#include "source/draw/PanelDrawing.h"
#include "source/draw/preview/PreviewScene.h"
#include "source/draw/preview/PreviewView.h"

namespace ray {

/// How finely a preview is drawn, by default in full; see MotionDetail.
struct DrawingDetail {
  int pixel_step = 1;     // faces, and what is behind them, have one pixel for so many of the view, each way
  bool is_smooth = true;  // faces have several samples per pixel, where they have every pixel
  friend bool operator==(const DrawingDetail&, const DrawingDetail&) = default;
};

/// All that a viewer shows at a moment; knows nothing of OpenGL. Lists are shared and never changed once they are
/// shown: the same pointer is the same list.
struct FrameState {
  /// A picture that is being rendered, or a finished one: either a frame or an image.
  struct Picture {
    const Frame* frame = nullptr;  // lives until the viewer handles its next event
    std::uint64_t number = 0;      // of the job that owns the frame
    std::shared_ptr<const R2::Image> image;
    std::optional<std::array<std::array<float, 3>, 4>> corners;  // in the drawing space; without them it is flat
    PixelBox place;                                              // where it is then, in the view
    int rows = -1;                                               // shown, from the bottom; -1: all
    Exposure exposure;
    double opacity = 1;  // over the preview, in [0, 1]
    /// The distances from the eye of what the picture shows, which hides lines behind it; without a frame it hides
    /// none.
    struct Depths {
      const Frame* frame = nullptr;  // likewise; 0 where nothing is hit
      std::uint64_t number = 0;
      double unit = 1;  // of the drawing space
    } depths{};
  };

  DrawingSize size;  // of the whole
  DrawingSize view;  // of the part, at the left, that shows the scene
  int bottom = 0;    // of that, and of the cross section, in pixels from the bottom of the whole
  R2::Color background;
  ClipMatrix clip_from_drawing{};
  PreviewView seen_from;
  std::shared_ptr<const PreviewScene> faces;  // null while they are being made
  bool shows_faces = true, shows_edges = false, shows_shadows = false;
  DrawingDetail detail;
  Rgba edge_color{};
  std::shared_ptr<const Lines> lines;
  std::shared_ptr<const Lines> marks;  // likewise, made anew for each view
  std::shared_ptr<const Lines> lit;    // likewise, in wide lines; null for none
  std::shared_ptr<const Lines> crop;   // likewise, the frame of the crop, which nothing hides; null for none
  std::optional<Picture> quad, picture;
  int split = -1;                 // the column from which on `beside` is seen instead of `picture`; -1 for none
  std::optional<Picture> beside;  // an image; without one it is the preview, drawn at the place of the picture
  DrawingSize section_size;       // of the part to the right of that, with the cross section
  R2::Color section_ground;
  std::shared_ptr<const Lines> section;  // in the square from -1 to 1, which is that part; null for none
  int line_width = 1;                    // pixels
  std::vector<Label> labels;
  std::shared_ptr<const PanelDrawing> panels;  // labels among them; null for none
};

}  // namespace ray
