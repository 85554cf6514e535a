#pragma once

#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/CoarseDrawer.h"
#include "source/draw/gl/ImageDrawer.h"
#include "source/draw/gl/ListDrawer.h"
#include "source/draw/gl/PanelDrawer.h"
#include "source/draw/gl/SurfaceDrawer.h"

namespace ray {

/// Draws with OpenGL 3.3 core into the context that is current at its creation. That context must be current for every
/// call, and outlive the painter and all that it uploaded.
struct Painter {
  /// Throws ContextError if the driver rejects a shader.
  explicit Painter(Canvas::Target target) : canvas(target) {}

  Canvas canvas;
  SurfaceDrawer surfaces;
  CoarseDrawer coarse;
  ListDrawer lists;
  ImageDrawer images;
  PanelDrawer panels;
};

}  // namespace ray
