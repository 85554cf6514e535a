#pragma once

#include <string>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/render/Render.h"

namespace ray {

/// Everything that a bit of the picture depends on: version, scene, and the options that choose it; lines "name value".
/// But for the samples, which may become more.
std::string IdentityOf(const RenderOptions& options, const std::string& scene_hash);

/// The state of a render in a file beside the picture so far, from which -resume continues: "out.jpg.checkpoint", or
/// "out.partial.jpg.checkpoint" where a finished picture has the name. It is written every -checkpoint, and whenever a
/// signal ends the run, whole or not at all; removed when the picture is finished, unless -keep_checkpoint wants
/// samples to be added later. No other render removes or replaces it.
class Checkpoint {
 public:
  /// Throws OutputError when the file could not be written, UsageError when there is one and neither -resume nor
  /// -restart says what is to become of it.
  ///   is_of_course   the command line of a course has neither option
  Checkpoint(const FileOptions& files, const CheckpointOptions& options, bool is_of_course);

  /// A failure is a warning and loses nothing: the state is kept in the temporary folder until a later one is saved.
  ///   identity   IdentityOf the image
  void Save(const RenderState& state, const std::string& identity);
  bool Exists() const { return Found() != nullptr; }
  /// Throws SceneErrors when there is none, or none of this identity; but the samples may have become more, see
  /// CheckPlan.
  RenderState Load(const Film& film, const RenderSettings& settings, const std::string& identity) const;
  /// With the copy in the temporary folder, if there is one.
  void Remove();
  /// Once the picture is in its place: what is left of it unfinished goes, and with it the checkpoint unless it is to
  /// be kept beside the picture.
  void PictureIsFinished(bool keep);
  const std::string& Name() const { return has_picture_ ? aside_.name : beside_.name; }

 private:
  const OutputFile* Found() const;
  void RemoveCopy();

  const std::string picture_;
  bool has_picture_;           // a finished one had the name when the render began
  OutputFile beside_, aside_;  // the two names
  bool had_aside_;
  std::string kept_as_;  // the copy; empty for none
};

}  // namespace ray
