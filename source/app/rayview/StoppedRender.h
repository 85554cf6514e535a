#pragma once

#include <optional>
#include <string>

#include "source/app/files/Checkpoint.h"
#include "source/view/live/RenderJob.h"

namespace ray {

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
