#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/draw/Drawing.h"
#include "source/draw/preview/PreviewScene.h"
#include "source/inspect/LoadedScene.h"
#include "source/parse/SceneError.h"
#include "source/view/LatestJob.h"

namespace ray {

/// The scene that is shown, as it is traced and as it is drawn; and the mistakes of a file that was to be shown
/// instead.
class ViewedScene {
 public:
  void Take(std::shared_ptr<const LoadedScene> scene);
  /// Begins to make its preview, for these settings, in the background. If that takes no longer than a moment it
  /// is there at once; otherwise TakeFaces returns true once it is.
  void MakeFaces(const RenderSettings& settings);
  /// Takes the last preview that was begun if it is complete, or waits for it. Returns true if Faces has changed.
  bool TakeFaces(bool waits = false);
  bool IsMakingFaces() const { return making_.IsBusy(); }

  const LoadedScene& Loaded() const { return *loaded_; }
  const std::shared_ptr<const LoadedScene>& Shared() const { return loaded_; }
  const Scene& Parsed() const { return loaded_->parsed.scene; }
  const World& world() const { return loaded_->world; }
  /// Returns true if nothing in it can be seen.
  bool ShowsNothing() const { return world().Instances().empty() && !Parsed().environment; }
  const DrawingSpace& Space() const { return space_; }
  /// The preview; null while it is being made.
  const std::shared_ptr<const PreviewScene>& Faces() const { return faces_; }
  /// Describes the parts of the scene that the preview does not show; empty if it shows all.
  const std::string& Notes() const { return notes_; }
  /// The number of scenes opened or read again so far.
  int Number() const { return number_; }

  /// Keeps the mistakes of a file that cannot be read; the current scene stays.
  void KeepMistakes(const std::string& file, const std::exception& error);
  void ForgetMistakes() { mistakes_.clear(); }
  /// Empty if there are none.
  const std::vector<SceneError>& Mistakes() const { return mistakes_; }
  /// The file that has them.
  const std::string& MistakenFile() const { return mistaken_file_; }

 private:
  void AddNote(const std::string& note) { notes_ += (notes_.empty() ? "" : ", ") + note; }

  std::shared_ptr<const LoadedScene> loaded_;
  DrawingSpace space_;
  std::shared_ptr<const PreviewScene> faces_;
  LatestJob<PreviewScene> making_;
  std::string notes_;
  int number_ = 0;
  std::vector<SceneError> mistakes_;
  std::string mistaken_file_;
};

}  // namespace ray
