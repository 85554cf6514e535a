#pragma once

#include <functional>

#include "source/draw/gl/Objects.h"
#include "source/draw/preview/PreviewView.h"
#include "source/draw/preview/Surfaces.h"

/// What mirrors show: cube maps of light, with the distance in the fourth channel.
namespace ray {

/// One side of a cube about a probe, in the order of OpenGL: +x, -x, +y, -y, +z, -z.
struct ProbeSide {
  PreviewView view;
  ClipMatrix clip_from_drawing;
};
ProbeSide SideOf(const MirrorProbe& probe, int side);

/// A cube map in half precision of so many texels a side, whose sides are each drawn by `draw(side)` over the
/// background, endlessly far away, with smaller levels. What was being drawn into goes on. Throws ContextError when
/// memory is full.
Texture2D FilledProbe(GLsizei texels, const R2::Color& background, const std::function<void(int side)>& draw);

}  // namespace ray
