#include "source/view/ViewedScene.h"

#include <exception>
#include <utility>

#include "source/text/Words.h"

namespace ray {

void ViewedScene::Take(std::shared_ptr<const LoadedScene> scene) {
  loaded_ = std::move(scene);
  ++number_;
  mistakes_.clear();
  const DrawingSpace space = DrawingSpace::Of(Parsed().root.bounds);
  if (space.radius != space_.radius || space.center != space_.center) faces_.reset();  // they are elsewhere
  space_ = space;
}

void ViewedScene::MakeFaces(const RenderSettings& settings) {
  making_.Begin([scene = loaded_, settings, space = space_] { return PreviewOf(scene->world, settings, space); });
  TakeFaces();
}

bool ViewedScene::TakeFaces(bool waits) {
  std::shared_ptr<const PreviewScene> faces;
  std::string problem;
  try {
    auto made = making_.Take(waits);
    if (!made) return false;
    faces = std::make_shared<const PreviewScene>(std::move(*made));
  } catch (const std::exception& error) {  // such as too little memory; the traced image may still be made
    faces = std::make_shared<const PreviewScene>();
    problem = std::string("there is no preview: ") + error.what();
  }
  notes_ = problem;
  if (faces->simplified > 0)
    AddNote(std::to_string(faces->simplified) + (faces->simplified == 1 ? " mesh" : " meshes") + " simplified");
  if (faces->as_boxes > 0)
    AddNote(Counted(static_cast<std::uint64_t>(faces->as_boxes), "primitive") + " shown as boxes");
  if (faces->left_out > 0) AddNote(std::to_string(faces->left_out) + " not shown");
  if (faces->lights.left_out > 0)
    AddNote(Counted(static_cast<std::uint64_t>(faces->lights.left_out), "weaker light") + " left out of the preview");
  if (faces->lights.head_light) AddNote("the scene is unlit: the preview has a light at the eye");
  faces_ = std::move(faces);
  return true;
}

void ViewedScene::KeepMistakes(const std::string& file, const std::exception& error) {
  const auto* errors = dynamic_cast<const SceneErrors*>(&error);
  SceneError other;
  other.file = file;
  other.message = error.what();
  mistaken_file_ = file;
  mistakes_ = errors ? errors->All() : std::vector{other};
}

}  // namespace ray
