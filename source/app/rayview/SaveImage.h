#pragma once

#include <string>

#include "source/app/rayview/ViewOutputs.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// Writes a traced image as raypro would, byte for byte; a camera other than the scene's own is stored in the image.
///   output    null: the next free name, see ClaimImageName
///   options   with `render` as it was traced
///   result    complete
///   seconds   that it took
///   returns   the line that raypro would print
/// Throws OutputError, and R2::ImageError if the format does not support the size.
std::string SaveTraced(const ImageOutput* output, RenderOptions options, const LoadedScene& scene,
                       const RenderResult& result, double seconds);

/// Writes a drawing, whose values are as displayed. Throws OutputError, and R2::ImageError if the format does not
/// support the size.
void SaveDrawing(const ImageOutput& output, const R2::Image& drawing, R2::ImageEncoding encoding);

}  // namespace ray
