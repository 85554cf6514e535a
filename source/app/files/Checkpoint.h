#pragma once

#include <string>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/render/Render.h"

namespace ray {

/// Returns everything that affects the bits of the image, except the number of samples, which may increase: version,
/// scene, and the options that determine it; lines "name value".
std::string IdentityOf(const RenderOptions& options, const std::string& scene_hash);

/// The state of a render in a file next to the image so far, from which -resume continues: "out.jpg.checkpoint", or
/// "out.partial.jpg.checkpoint" if a finished image has the name. It is written every -checkpoint seconds, and when a
/// signal ends the run, completely or not at all. It is removed when the image is finished, unless -keep_checkpoint is
/// set so that samples can be added later. No other render removes or replaces it.
class Checkpoint {
 public:
  /// Throws OutputError if the file could not be written, UsageError if it exists and neither -resume nor -restart is
  /// given.
  ///   is_of_course   the command line of a course, which has neither option
  Checkpoint(const FileOptions& files, const CheckpointOptions& options, bool is_of_course);

  /// Saves the state. A failure is a warning and loses nothing: the state is saved in the temporary folder until a
  /// later one succeeds.
  ///   identity   IdentityOf the image
  void Save(const RenderState& state, const std::string& identity);
  bool Exists() const { return Found() != nullptr; }
  /// Loads the state. Throws SceneErrors if there is none with this identity; the number of samples may have increased,
  /// see CheckPlan.
  RenderState Load(const Film& film, const RenderSettings& settings, const std::string& identity) const;
  /// Removes the checkpoint, and its copy in the temporary folder, if there is one.
  void Remove();
  /// Called after the image was written: removes its partial image, and the checkpoint unless it is to be kept next to
  /// the image.
  void ImageIsFinished(bool keep);
  const std::string& Name() const { return has_image_ ? aside_.name : beside_.name; }

 private:
  const OutputFile* Found() const;
  void RemoveCopy();

  const std::string image_name_;
  bool has_image_;             // a finished image had the name when the render began
  OutputFile beside_, aside_;  // the two names
  bool had_aside_;
  std::string kept_as_;  // the copy; empty for none
};

}  // namespace ray
