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
  /// Begins to make its preview, for these settings, in the background. What takes no longer than a moment is there at
  /// once; else TakeFaces says when.
  void MakeFaces(const RenderSettings& settings);
  /// Takes the preview that was begun last, if it is made by now, or waits for it. Returns whether Faces is another.
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
  /// Returns a description of what the preview leaves out; empty if it leaves out nothing.
  const std::string& Notes() const { return notes_; }
  /// Another for each scene that was opened or read again, from 1.
  int Number() const { return number_; }

  /// `file` was to be read, and cannot be; the scene shown stays.
  void KeepMistakes(const std::string& file, const std::exception& error);
  void ForgetMistakes() { mistakes_.clear(); }
  /// Empty where nothing is wrong.
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
