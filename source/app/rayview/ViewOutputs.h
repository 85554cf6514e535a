#pragma once

#include <optional>
#include <span>
#include <string>

#include "source/app/files/Outputs.h"
#include "source/app/options/ViewerOptions.h"

namespace ray {

/// Output files of a rayview session that the user named.
struct ViewOutputs {
  std::optional<ImageOutput> image;         // for the image traced by key S
  std::optional<ImageOutput> output_image;  // for the window's final content
  std::optional<ImageOutput> screenshot;    // for the drawing after the last event
  std::optional<OutputFile> record;         // for the recorded events
};

/// Checks the outputs before anything is read: image formats are known and support `width` by `height` pixels, all
/// files can be written, and no two outputs and no input are the same file. Throws UsageError and OutputError.
ViewOutputs CheckViewOutputs(const FileOptions& files, const ViewOptions& view, int width, int height);

/// Throws OutputError if one of them is a file from which the scene was read.
void RefuseInputs(const ViewOutputs& outputs, std::span<const std::string> inputs);

/// Returns the first of image1.jpg, image2.jpg... in the current folder that does not exist, with this or another
/// extension of a writable image format. Creates it empty, so that nobody else takes it. Throws OutputError.
ImageOutput ClaimImageName(const std::string& extension);

}  // namespace ray
