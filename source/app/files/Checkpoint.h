#pragma once

#include <string>

#include "source/app/files/OutputFile.h"
#include "source/app/options/Options.h"
#include "source/render/Render.h"

namespace ray {

/// The state of a render in a file beside its picture, "out.jpg.checkpoint", from which -resume goes on. It is written
/// every -checkpoint, and whenever a signal ends the run, whole or not at all; removed when the picture is finished,
/// unless -keep_checkpoint wants samples to be added later.
class Checkpoint {
 public:
  /// Throws OutputError when the file could not be written.
  explicit Checkpoint(const Options& options);

  /// A failure is told and costs no picture.
  void Save(const RenderState& state, const std::string& scene_hash) const;
  bool Exists() const;
  /// Throws SceneErrors when there is none, or none of this scene, these settings and this version; but the samples may
  /// have become more, see CheckPlan.
  RenderState Load(const Film& film, const std::string& scene_hash) const;
  void Remove() const;
  const std::string& Name() const { return file_.name; }

 private:
  const Options& options_;
  OutputFile file_;
};

}  // namespace ray
