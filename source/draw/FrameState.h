#pragma once

#include <memory>
#include <optional>
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

/// The detail of a drawn preview, full by default; see MotionDetail.
struct DrawingDetail {
  // surfaces and background have one pixel for this many of the view, in each direction
  int pixel_step = 1;
  bool is_smooth = true;  // several samples per pixel, if pixel_step is 1
  friend bool operator==(const DrawingDetail&, const DrawingDetail&) = default;
};

inline constexpr double hidden_lines = 0.3;  // factor of the alpha of hidden lines

/// The displayed state of a viewer, without reference to OpenGL. Lists are shared and never changed once they are
/// shown: equal pointers are equal lists.
struct FrameState {
  /// An image that is being rendered, or a finished one: either a frame or an image.
  struct ShownImage {
    const Frame* frame = nullptr;  // valid until the viewer handles its next event
    std::uint64_t number = 0;      // of the job that owns the frame
    std::shared_ptr<const R2::Image> image;
    std::optional<std::array<std::array<float, 3>, 4>> corners;  // in the drawing space; without them the image is flat
    PixelBox place;                                              // of a flat image, in the view
    int rows = -1;                                               // shown, from the bottom; -1: all
    Exposure exposure;
    double opacity = 1;  // over the preview, in [0, 1]
    /// The distances of the image's surfaces from the eye, which hide lines behind them; without a frame none are
    /// hidden.
    struct Depths {
      const Frame* frame = nullptr;  // 0 where nothing is hit
      std::uint64_t number = 0;
      double unit = 1;  // of the drawing space
    } depths{};
  };

  DrawingSize size;  // of the whole drawing
  DrawingSize view;  // of the part, at the left, that shows the scene
  int bottom = 0;    // of the view and the cross section, in pixels from the bottom of the whole
  R2::Color background;
  ClipMatrix clip_from_drawing{};
  PreviewView seen_from;
  std::shared_ptr<const PreviewScene> faces;  // null while they are being created
  bool shows_faces = true, shows_edges = false, shows_shadows = false;
  DrawingDetail detail;
  Rgba edge_color{};
  std::shared_ptr<const Lines> lines;
  std::shared_ptr<const Lines> marks;  // lines that depend on the view
  std::shared_ptr<const Lines> lit;    // wide lines; null for none
  std::shared_ptr<const Lines> crop;   // the frame of the crop, which nothing hides; null for none
  // lines, marks and lit ones are in the square from -1 to 1, which is the view, instead of in space
  bool has_flat_lines = false;
  std::optional<ShownImage> quad, covering;
  // the column at which the covering image ends; -1 for none
  int split = -1;
  // an image; without one the preview, drawn at the place of the covering image
  std::optional<ShownImage> beside;
  // of the part to the right of the view, with the cross section
  DrawingSize section_size;
  R2::Color section_ground;
  // in the square from -1 to 1, which is the cross section; null for none
  std::shared_ptr<const Lines> section;
  int line_width = 1;                    // pixels
  std::vector<Label> labels;
  std::shared_ptr<const PanelDrawing> panels;  // including labels; null for none
};

}  // namespace ray
