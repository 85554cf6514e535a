#pragma once

#include <functional>

#include "source/draw/gl/Objects.h"

namespace ray {

/// Depths of a scene as its lights see it, layer by layer, to be compared with.
struct GpuShadows {
  Texture2D maps;  // an array
};

/// `count` maps, at least 1, each drawn by `draw(map)`, of which only the depth is kept. What was being drawn into goes
/// on. Throws ContextError when memory is full.
GpuShadows FilledShadows(int count, const std::function<void(int map)>& draw);

}  // namespace ray
