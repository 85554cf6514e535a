#pragma once

#include <string>

#include "source/app/rayview/ViewOutputs.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// Writes what was traced as raypro would, byte for byte; where the camera is not the scene's own, the picture keeps
/// it.
///   output    null: the next free name, see ClaimImageName
///   options   with `render` as it was traced
///   result    complete
///   seconds   that it took
///   returns   the line that raypro would print
/// Throws OutputError, and R2::ImageError when the format cannot hold the size.
std::string SaveTraced(const PictureOutput* output, RenderOptions options, const LoadedScene& scene,
                       const RenderResult& result, double seconds);

/// Writes what was drawn, whose values are as they are shown. Throws OutputError, and R2::ImageError when the format
/// cannot hold the size.
void SaveDrawing(const PictureOutput& output, const R2::Image& drawing, R2::ImageEncoding encoding);

}  // namespace ray
