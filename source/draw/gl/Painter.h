#pragma once

#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/CoarseDrawer.h"
#include "source/draw/gl/ListDrawer.h"
#include "source/draw/gl/PanelDrawer.h"
#include "source/draw/gl/PictureDrawer.h"
#include "source/draw/gl/SurfaceDrawer.h"

namespace ray {

/// Draws with OpenGL 3.3 core into the context that is current when it is made. That context must be current for every
/// call, and outlive the painter and all that it uploaded.
struct Painter {
  /// Throws ContextError when the driver rejects a shader.
  explicit Painter(Canvas::Target target) : canvas(target) {}

  Canvas canvas;
  SurfaceDrawer surfaces;
  CoarseDrawer coarse;
  ListDrawer lists;
  PictureDrawer pictures;
  PanelDrawer panels;
};

}  // namespace ray
