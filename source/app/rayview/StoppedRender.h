#pragma once

#include <optional>
#include <string>

#include "source/app/files/Checkpoint.h"
#include "source/view/live/RenderJob.h"

namespace ray {

/// The checkpoint of a picture of key S that was stopped, from which raypro -resume goes on.
class StoppedRender {
 public:
  /// `options`: with `render` as it was traced. Returns in words how it goes on; why it was not kept; or nothing where
  /// there is no name to keep it under.
  std::string Keep(const RenderJob& stopped, RenderOptions options);
  /// The job is complete, and its picture about to be saved: its checkpoint goes, if it was kept.
  void Finished(const RenderJob& complete, RenderOptions options);

 private:
  std::optional<Checkpoint> checkpoint_;
  std::string identity_;  // of what it holds
};

}  // namespace ray
