#include "source/view/commands/FlatImage.h"

#include <cmath>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double zoom_of_a_step = 1.25;
constexpr double reach_of_slider = 5;       // pixels to each side in which it is taken hold of
constexpr double largest_preview = 16'384;  // pixels a side: OpenGL's least limit of a viewport, where it has one
constexpr double largest_picture = 262'144;

}  // namespace

void ToggleFlat(ViewerState& viewer) {
  viewer.notices.RedrawLines();
  if (viewer.flat.IsShown()) {
    viewer.flat.Hide();
    return viewer.notices.Tell("flat image off");
  }
  if (!viewer.pictures.Trace() && !viewer.pictures.IsLive())
    return viewer.notices.Tell("nothing is rendered yet; press S or P first");
  viewer.flat.Show();
  viewer.notices.Tell("flat image: wheel zooms, drag moves, Shift+drag slides against the " +
                      std::string(viewer.pictures.Reference() ? "reference" : "preview"));
}

void DragFlat(ViewerState& viewer, const R2::Point& from, const R2::Point& to, bool moves_slider) {
  if (moves_slider) {
    if (!viewer.pictures.Reference() && viewer.PlaceOfPicture().width > largest_preview)
      return viewer.notices.Tell("zoom out to slide against the preview");
    viewer.flat.SetSlider(to.x / viewer.layout().view.width);
    viewer.notices.Tell("slider at " + Rounded(100 * viewer.flat.Slider(), 3) + " %");
  } else {
    viewer.flat.Pan(to - from);
  }
  viewer.notices.Redraw();
}

bool TakesSlider(const ViewerState& viewer, const ButtonEvent& event) {
  return event.modifiers.shift ||
         std::abs(event.x - viewer.flat.Slider() * viewer.layout().view.width) <= reach_of_slider;
}

void ZoomFlat(ViewerState& viewer, const ScrollEvent& event) {
  viewer.flat.Zoom(R1::Pow(zoom_of_a_step, event.steps), {event.x, event.y}, viewer.FittingPicture(),
                   viewer.pictures.Reference() || viewer.flat.Slider() == 1 ? largest_picture : largest_preview);
  viewer.notices.Tell("zoom " + Fixed(100 * viewer.PlaceOfPicture().width / viewer.SettingsOfPicture().width, 0) +
                      " %");
}

}  // namespace ray
