#pragma once

#include <optional>
#include <string>

#include "source/app/files/Checkpoint.h"
#include "source/app/rayview/ViewOutputs.h"
#include "source/inspect/LoadedScene.h"
#include "source/view/live/RenderJob.h"

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

/// The checkpoint of a stopped image of key S, from which raypro -resume continues.
class StoppedRender {
 public:
  /// Saves the checkpoint; `options` has `render` as it was traced. Returns a message on how to continue, or why it was
  /// not saved; empty if there is no name to save it under.
  std::string Keep(const RenderJob& stopped, RenderOptions options);
  /// Removes the checkpoint of a job, if it was saved; called when the job is complete, before its image is saved.
  void Finished(const RenderJob& complete, RenderOptions options);

 private:
  std::optional<Checkpoint> checkpoint_;
  std::string identity_;  // of the saved checkpoint
};

}  // namespace ray
