#include "source/view/ViewedScene.h"

#include <chrono>
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
  constexpr std::chrono::milliseconds moment{20};
  std::erase_if(ending_,
                [](auto& faces) { return faces.wait_for(std::chrono::seconds{0}) == std::future_status::ready; });
  if (making_.valid()) ending_.push_back(std::move(making_));
  making_ = std::async(std::launch::async, [scene = loaded_, settings, space = space_] {
    return PreviewOf(scene->world, settings, space);
  });
  making_.wait_for(moment);
  TakeFaces();
}

bool ViewedScene::TakeFaces(bool waits) {
  if (!making_.valid()) return false;
  if (!waits && making_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return false;
  notes_.clear();
  std::shared_ptr<const PreviewScene> faces;
  try {
    faces = std::make_shared<const PreviewScene>(making_.get());
  } catch (const std::exception& problem) {  // such as too little memory; the traced image may still be made
    faces = std::make_shared<const PreviewScene>();
    AddNote(std::string("there is no preview: ") + problem.what());
  }
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
