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

  /// A failure is told and costs no picture: the state is kept in the temporary folder, until a later one is saved.
  void Save(const RenderState& state, const std::string& scene_hash);
  bool Exists() const;
  /// Throws SceneErrors when there is none, or none of this scene, these settings and this version; but the samples may
  /// have become more, see CheckPlan.
  RenderState Load(const Film& film, const RenderSettings& settings, const std::string& scene_hash) const;
  /// With the copy in the temporary folder, if there is one.
  void Remove();
  const std::string& Name() const { return file_.name; }

 private:
  void RemoveCopy();

  const Options& options_;
  OutputFile file_;
  std::string kept_as_;  // the copy; empty for none
};

}  // namespace ray
