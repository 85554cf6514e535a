#pragma once

#include <optional>
#include <span>
#include <string>

#include "source/app/files/Outputs.h"
#include "source/app/options/ViewerOptions.h"

namespace ray {

/// Where a run of rayview writes to, as far as the user named it.
struct ViewOutputs {
  std::optional<PictureOutput> image;         // what key S traces
  std::optional<PictureOutput> output_image;  // what is shown at the end
  std::optional<PictureOutput> screenshot;    // what is drawn after the last event
  std::optional<OutputFile> record;           // what happened
};

/// Before anything is read: pictures have known kinds that can hold `width` by `height` pixels, everything can be
/// written, no two outputs and no input are the same file. Throws UsageError and OutputError.
ViewOutputs CheckViewOutputs(const FileOptions& files, const ViewOptions& view, int width, int height);

/// Throws OutputError when one of them is a file the scene was read from.
void RefuseInputs(const ViewOutputs& outputs, std::span<const std::string> inputs);

/// image1.jpg, image2.jpg... or with another extension of a picture that can be written: the first that is not there,
/// in the current folder. It is there, and empty, from now on, so that nobody else takes it. Throws OutputError.
PictureOutput ClaimImageName(const std::string& extension);

}  // namespace ray
