#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/draw/Drawing.h"
#include "source/draw/preview/ScenePicture.h"
#include "source/parse/SceneError.h"
#include "source/view/LoadedScene.h"

namespace ray {

/// The scene that is shown, as it is traced and as it is drawn; and the mistakes of a file that was to be shown
/// instead.
class ViewedScene {
 public:
  void Take(std::shared_ptr<const LoadedScene> scene);
  /// Makes what is drawn of it, for these settings.
  void MakeFaces(const RenderSettings& settings);

  const LoadedScene& Loaded() const { return *loaded_; }
  const std::shared_ptr<const LoadedScene>& Shared() const { return loaded_; }
  const Scene& Parsed() const { return loaded_->parsed.scene; }
  const World& world() const { return loaded_->world; }
  const DrawingSpace& Space() const { return space_; }
  const std::shared_ptr<const ScenePicture>& Faces() const { return faces_; }
  /// The scene's surfaces in few triangles, for views that move on a slow renderer; null where Faces are few enough.
  /// Made when they are first asked for.
  const std::shared_ptr<const Surfaces>& FacesInMotion();
  /// What is drawn otherwise than it is traced, in words; empty where nothing is.
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
  std::shared_ptr<const ScenePicture> faces_;
  RenderSettings made_for_;  // settings of these
  std::shared_ptr<const Surfaces> faces_in_motion_;
  std::string notes_;
  int number_ = 0;
  std::vector<SceneError> mistakes_;
  std::string mistaken_file_;
};

}  // namespace ray
