#include <algorithm>

#include "source/view/Viewer.h"

/// The cross section beside the scene.
namespace ray {

DrawingSize Viewer::ViewSize() const {
  const int width = section_.IsShown() ? std::max(1, WidthBesidePanels() / 2) : WidthBesidePanels();
  return {width, HeightBelowStatusBar()};
}

DrawingSize Viewer::SectionSize() const { return {WidthBesidePanels() - ViewSize().width, ViewSize().height}; }

int Viewer::WidthBesidePanels() const {
  return std::max(1, size_.width - (shows_panels_ ? static_cast<int>(panels_->Width(*this)) : 0));
}

int Viewer::HeightBelowStatusBar() const {
  return std::max(1, size_.height - (shows_panels_ ? static_cast<int>(panels_->HeightOfBar()) : 0));
}

bool Viewer::IsOnSection(const R2::Point& position) const {
  const double left = ViewSize().width;
  return section_.IsShown() && position.x >= left && position.x < left + SectionSize().width && position.y >= 0 &&
         position.y < SectionSize().height;
}

R2::Point Viewer::InPicture(const R2::Point& position) const {
  const PixelBox place = PlaceOfPicture();
  const RenderSettings settings = SettingsOfPicture();
  return {(position.x - place.left) / place.width * settings.width,
          (position.y - place.bottom) / place.height * settings.height};
}

PixelBox Viewer::FittingPicture() const {
  // In the middle of the view: of its own view, where the scene is drawn as the picture shows it.
  const RenderSettings settings = SettingsOfPicture();
  const DrawingSize view = ViewSize();
  const double across = static_cast<double>(view.width) / settings.width;
  const double scale = std::min(across, static_cast<double>(view.height) / settings.height);
  const double width = scale * settings.width, height = scale * settings.height;
  return {(view.width - width) / 2, (view.height - height) / 2, width, height};
}

void Viewer::ToggleSection() {
  section_.Toggle();
  arrows_move_section_ = section_.IsShown();
  section_drawing_.reset();
  ShowMessage(section_.IsShown() ? "cross section on" : "cross section off");
}

void Viewer::MoveSection(int by) {
  section_.Move(by, size_.height);
  arrows_move_section_ = true;
  section_drawing_.reset();
  if (section_.IsShown()) MakeSection();
  ShowMessage("cross section: " + section_.Describe(size_.height));
}

void Viewer::MakeSection() {
  if (section_drawing_ && section_size_ == SectionSize()) return;
  section_size_ = SectionSize();
  section_.Cut(*scene_, SettingsOfView(), navigator_.Center(), section_size_, rays_.Counts());
  section_drawing_ =
      std::make_shared<const SliceAxes>(section_.Drawing(*scene_, rays_.Look().WithoutChoice(), panels_->Letters()));
}

std::string Viewer::TextOfSection() const {
  if (!section_drawing_ || !IsOnSection(pointer_)) return {};
  const auto on_section = [&](const R2::Point& p) { return R2::Point{p.x - ViewSize().width, p.y}; };
  const bool measures = press_ && press_->on_section;
  return section_.Tell(on_section(pointer_), measures ? std::optional(on_section(press_->at)) : std::nullopt);
}

}  // namespace ray
