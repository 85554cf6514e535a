#include "source/view/ViewedScene.h"

#include <utility>

#include "source/text/EnumNames.h"
#include "source/text/Words.h"

namespace ray {

void ViewedScene::Take(std::shared_ptr<const LoadedScene> scene) {
  loaded_ = std::move(scene);
  ++number_;
  mistakes_.clear();
  space_ = DrawingSpace::Of(Parsed().root.bounds);
}

void ViewedScene::MakeFaces(const RenderSettings& settings) {
  ScenePicture picture = PictureOf(world(), settings, space_);
  notes_.clear();
  if (picture.as_boxes > 0)
    AddNote(Counted(static_cast<std::uint64_t>(picture.as_boxes), "primitive") + " shown as boxes");
  if (picture.left_out > 0) AddNote(std::to_string(picture.left_out) + " not shown");
  if (picture.lights.left_out > 0)
    AddNote(Counted(static_cast<std::uint64_t>(picture.lights.left_out), "weaker light") + " left out of the preview");
  if (settings.mode != RenderMode::whitted)
    AddNote(std::string("mode ") + NameOf(settings.mode) +
            (IsPreviewed(settings.mode) ? "" : ", which the preview does not show"));
  if (picture.lights.head_light) AddNote("the scene is unlit: seen by a light at the eye");
  faces_ = std::make_shared<const ScenePicture>(std::move(picture));
  made_for_ = settings;
  faces_in_motion_.reset();
}

const std::shared_ptr<const Surfaces>& ViewedScene::FacesInMotion() {
  constexpr std::size_t enough = 150'000;  // triangles
  if (!faces_in_motion_ && faces_->surfaces.indices.size() / 3 > enough)
    faces_in_motion_ =
        std::make_shared<const Surfaces>(PictureOf(world(), made_for_, space_, budget_in_motion).surfaces);
  return faces_in_motion_;
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
