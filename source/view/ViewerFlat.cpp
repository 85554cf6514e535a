#include <cmath>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"
#include "source/view/Viewer.h"

/// The rendered picture shown flat.
namespace ray {
namespace {

constexpr double zoom_of_a_step = 1.25;
constexpr double reach_of_slider = 5;       // pixels to each side in which it is taken hold of
constexpr double largest_picture = 16'384;  // pixels a side: OpenGL's least limit of a viewport, where it has one

}  // namespace

const RenderJob* Viewer::FlatJob() const {
  if (!flat_.IsShown()) return nullptr;
  return pictures_.IsLive() ? pictures_.Live() : pictures_.Trace();
}

RenderSettings Viewer::SettingsOfPicture() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings() : SettingsOfView();
}

Camera Viewer::CameraOfPicture() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings().view.value_or(scene_->parsed.scene.camera) : navigator_.camera();
}

DrawingSize Viewer::SizeOfPreview() const {
  const RenderJob* job = FlatJob();
  return job ? DrawingSize{job->Settings().width, job->Settings().height} : ViewSize();
}

void Viewer::ToggleFlat() {
  InvalidateLines();
  if (flat_.IsShown()) {
    flat_.Hide();
    return ShowMessage("flat image off");
  }
  if (!pictures_.Trace() && !pictures_.IsLive()) return ShowMessage("nothing is rendered yet; press S or P first");
  flat_.Show();
  ShowMessage("flat image: wheel zooms, drag moves, Shift+drag slides against the " +
              std::string(pictures_.Reference() ? "reference" : "preview"));
}

void Viewer::DragFlat(const R2::Point& from, const R2::Point& to) {
  if (press_->moves_slider) {
    flat_.SetSlider(to.x / ViewSize().width);
    ShowMessage("slider at " + Rounded(100 * flat_.Slider(), 3) + " %");
  } else {
    flat_.Pan(to - from);
  }
  needs_redraw_ = true;
}

bool Viewer::TakesSlider(const ButtonEvent& event) const {
  return event.modifiers.shift || std::abs(event.x - flat_.Slider() * ViewSize().width) <= reach_of_slider;
}

void Viewer::ZoomFlat(const ScrollEvent& event) {
  flat_.Zoom(R1::Pow(zoom_of_a_step, event.steps), {event.x, event.y}, FittingPicture(), largest_picture);
  ShowMessage("zoom " + Rounded(100 * PlaceOfPicture().width / SettingsOfPicture().width, 4) + " %");
}

void Viewer::ShowFlat(FrameState& shown) const {
  if (!FlatJob() || !shown.picture) return;
  static const auto no_lines = std::make_shared<const Lines>();
  shown.lines = no_lines;
  shown.marks = shown.lit = nullptr;
  shown.shows_edges = false;
  shown.split = static_cast<int>(std::lround(flat_.Slider() * shown.view.width));
  if (!pictures_.Reference()) return;
  shown.beside = FrameState::Picture{};
  shown.beside->image = pictures_.Reference();
  shown.beside->exposure = shown.picture->exposure;
  shown.beside->place = shown.picture->place;
}

}  // namespace ray
